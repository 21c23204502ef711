// SPDX-License-Identifier: Apache-2.0
#include "optics/illuminants.h"

#include <cmath>
#include <map>
#include <numeric>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "optics/spectrum.h"

using namespace parhelion;

namespace {

using Source = ContinuousSpectrum::Source;

Vec2 chromaticity(const SpectrumSettings& spectrum) {
  const Vec3 white = Spectrum(spectrum).white();
  return Vec2(white.x, white.y) / (white.x + white.y + white.z);
}

/// CIE 1960 u, v.
Vec2 uniform(const Vec2& xy) { return Vec2(4.0 * xy.x, 6.0 * xy.y) / (-2.0 * xy.x + 12.0 * xy.y + 3.0); }

/// The Planckian locus in CIE 1960 u, v within 8e-5 and 9e-5 from 1000 to 15000 kelvin. Krystek 1985, Color Res. Appl.
/// 10, 38.
Vec2 krystek(double t) {
  return {
      (0.860117757 + 1.54118254e-4 * t + 1.28641212e-7 * t * t) / (1.0 + 8.42420235e-4 * t + 7.08145163e-7 * t * t),
      (0.317398726 + 4.22806245e-5 * t + 4.20481691e-8 * t * t) / (1.0 - 2.89741816e-5 * t + 1.61456053e-7 * t * t)};
}

}  // namespace

TEST_CASE("illuminants have the chromaticities that the CIE publishes") {
  // CIE 015:2018, 2-degree observer. They rest on steps of 5 nm, and those of D on a locus that misses
  // the weights' own chromaticity by 1e-4.
  const std::map<Source, Vec2> published = {{Source::a, {0.44758, 0.40745}},   {Source::d50, {0.34567, 0.35851}},
                                            {Source::d55, {0.33243, 0.34744}}, {Source::d65, {0.31272, 0.32903}},
                                            {Source::d75, {0.29903, 0.31488}}, {Source::e, {1.0 / 3.0, 1.0 / 3.0}}};
  for (const auto& [source, xy] : published) {
    CAPTURE(nameOf(source));
    CHECK(glm::distance(chromaticity(ContinuousSpectrum{source}), xy) < 1.5e-4);
  }
}

TEST_CASE("illuminant D65 has the powers that the CIE tabulates") {
  // CIE standard illuminant D65, ISO/CIE 11664-2, relative to 100 at 560 nm.
  const std::map<double, double> published = {
      {380, 49.9755}, {400, 82.7549}, {450, 117.008}, {500, 109.354}, {550, 104.046}, {560, 100.0},   {600, 90.0062},
      {650, 80.0268}, {690, 69.7213}, {700, 71.6091}, {740, 75.0870}, {760, 46.4182}, {780, 63.3828}, {830, 60.3125}};
  const Daylight d65 = illuminantD(6500.0);
  for (const auto& [wavelength, power] : published) CHECK(std::abs(100.0 * d65(wavelength) - power) < 1e-3);
  // Linear between the nodes.
  CHECK(d65(455.0) == doctest::Approx(0.5 * (d65(450.0) + d65(460.0))).epsilon(1e-12));
}

TEST_CASE("illuminant A has the powers that the CIE tabulates, and is a black body of 2856 kelvin") {
  // ISO/CIE 11664-2.
  const std::map<double, double> published = {{380, 9.79510}, {450, 33.0859}, {500, 59.8611}, {560, 100.0},
                                              {600, 129.043}, {700, 198.261}, {780, 241.675}};
  for (const auto& [wavelength, power] : published) {
    CHECK(100.0 * illuminantA(wavelength) == doctest::Approx(power).epsilon(1e-5));
    CHECK(illuminantA(wavelength) == doctest::Approx(blackBody(2855.5, wavelength)).epsilon(1e-3));
  }
}

TEST_CASE("black bodies lie on the Planckian locus, and shine most where Wien's law says") {
  for (const double temperature : {1000.0, 1500.0, 2000.0, 3000.0, 5000.0, 6500.0, 10000.0, 15000.0}) {
    CAPTURE(temperature);
    const Vec2 uv = uniform(chromaticity(BlackBody{temperature}));
    CHECK(std::abs(uv.x - krystek(temperature).x) < 2e-4);
    CHECK(std::abs(uv.y - krystek(temperature).y) < 2e-4);
  }
  const double peak = 2.897771955e6 / 5000.0;  // nm
  CHECK(blackBody(5000.0, peak) > blackBody(5000.0, peak - 5.0));
  CHECK(blackBody(5000.0, peak) > blackBody(5000.0, peak + 5.0));
}

TEST_CASE("the coldest and the hottest black body that scenes may ask for have finite light") {
  for (const double temperature : {500.0, 1e6}) {
    const Spectrum spectrum(BlackBody{temperature});
    for (int i = 0; i < 1000; ++i) {
      const SpectralSample sample = spectrum.sample((i + 0.5) / 1000);
      REQUIRE(std::isfinite(sample.light));
      REQUIRE(sample.light >= 0.0);
      // A few times the mean: nothing that a tally cannot hold.
      REQUIRE(sample.light < 10.0);
    }
  }
}

TEST_CASE("the sun is a black body of 5772 kelvin to the eye, within the lines that it lacks") {
  CHECK(glm::distance(chromaticity(BlackBody{}), chromaticity(ContinuousSpectrum{})) < 0.01);
}
