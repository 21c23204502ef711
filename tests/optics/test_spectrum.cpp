// SPDX-License-Identifier: Apache-2.0
#include "optics/spectrum.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "math/names.h"
#include "math/random.h"
#include "optics/tables.h"
#include "statistics.h"

using namespace parhelion;

namespace {

using Source = ContinuousSpectrum::Source;
const std::vector<SpectrumSettings> kContinuous = [] {
  std::vector<SpectrumSettings> all{BlackBody{1500.0}, BlackBody{20000.0}};
  for (const Source source : kMembersOf<Source>) all.emplace_back(ContinuousSpectrum{source});
  return all;
}();

Vec3 chromaticity(const Vec3& xyz) { return xyz / (xyz.x + xyz.y + xyz.z); }

/// Linear Rec.709, from the matrix of IEC 61966-2-1 (by columns).
Vec3 toRec709(const Vec3& xyz) {
  return Mat3(3.2406, -0.9689, 0.0557, -1.5372, 1.8758, -0.2040, -0.4986, 0.0415, 1.0570) * xyz;
}

/// Mean of a spectrum's samples over quantiles in the middle of equal steps.
template <class Value>
auto meanOf(const Spectrum& spectrum, const Value& value) {
  constexpr int kSteps = 200000;
  auto sum = value(spectrum.sample(0.5));
  sum -= sum;
  for (int i = 0; i < kSteps; ++i) sum += value(spectrum.sample((i + 0.5) / kSteps)) / double(kSteps);
  return sum;
}

/// Sum over the channels of the variance of one sample of sunlight, when wavelengths are drawn with a density
/// proportional to `weight(node)`.
template <class Weight>
double summedVariance(const Weight& weight) {
  double luminance = 0.0, weights = 0.0, squares = 0.0;
  Vec3 mean(0.0);
  for (int i = 0; i < kVisibleNodes; ++i) luminance += kSunExtraterrestrial[i] * kObserver1931[i].y;
  for (int i = 0; i < kVisibleNodes; ++i) weights += weight(i);
  for (int i = 0; i < kVisibleNodes; ++i) {
    const Vec3 light = toRec709(kSunExtraterrestrial[i] * kObserver1931[i]) / luminance;
    mean += light;
    squares += glm::dot(light, light) / (weight(i) / weights);
  }
  return squares - glm::dot(mean, mean);
}

}  // namespace

TEST_CASE("the tables of the observer and of sunlight add up to their published totals") {
  Vec3 observer(0.0);
  double above = 0.0, ground = 0.0;
  for (int i = 0; i < kVisibleNodes; ++i) {
    observer += kObserver1931[i];
    above += kSunExtraterrestrial[i];
    ground += kSunAirMass1_5[i];
    // Sunlight is dimmed on its way down.
    CHECK(kSunAirMass1_5[i] < kSunExtraterrestrial[i]);
  }
  CHECK(std::abs(observer.x - 106.865469) < 1e-6);
  CHECK(std::abs(observer.y - 106.856917) < 1e-6);
  CHECK(std::abs(observer.z - 106.892251) < 1e-6);
  CHECK(std::abs(above - 735.87839) < 1e-6);
  CHECK(std::abs(ground - 525.0461) < 1e-6);
}

TEST_CASE("the observer's response is smooth, and luminance peaks with 1 at 555 nm") {
  for (int w = kVisibleFirst + 1; w < kVisibleLast; ++w)
    for (int c = 0; c < 3; ++c)
      CHECK(std::abs(observer1931(w - 1)[c] - 2.0 * observer1931(w)[c] + observer1931(w + 1)[c]) < 0.007);
  CHECK(observer1931(555.0).y == 1.0);
  CHECK(observer1931(555.0).x == doctest::Approx(0.5120501).epsilon(1e-9));
  CHECK(observer1931(450.0).z == doctest::Approx(1.77211).epsilon(1e-9));
  CHECK(observer1931(500.5).y == doctest::Approx(0.5 * (0.323 + 0.3384021)).epsilon(1e-9));
  CHECK(observer1931(359.9) == Vec3(0.0));
  CHECK(observer1931(830.1) == Vec3(0.0));
}

TEST_CASE("the mean of a spectrum's samples is its white, whose luminance is 1") {
  for (const SpectrumSettings& settings : kContinuous) {
    const Spectrum spectrum(settings);
    CHECK(spectrum.white().y == doctest::Approx(1.0).epsilon(1e-12));
    CHECK(glm::distance(meanOf(spectrum, [](const auto& s) { return s.xyz; }), spectrum.white()) < 1e-5);
    CHECK(meanOf(spectrum, [](const auto& s) { return s.light; }) == doctest::Approx(1.0).epsilon(1e-5));
    CHECK(spectrum.colours() == 3);
    CHECK(spectrum.lines().empty());
  }
}

TEST_CASE(
    "the sun's white has the chromaticity of a 5800 kelvin body, reddened by air, and equal energy has 1/3, 1/3") {
  const auto whiteOf = [](Source source) { return chromaticity(Spectrum(ContinuousSpectrum{source}).white()); };
  const Vec3 sun = whiteOf(Source::extraterrestrial), ground = whiteOf(Source::airMass1_5);
  CHECK(sun.x > 0.32);
  CHECK(sun.x < 0.34);
  CHECK(sun.y > 0.33);
  CHECK(sun.y < 0.35);
  CHECK(ground.x > sun.x + 0.01);
  CHECK(glm::distance(whiteOf(Source::equal), Vec3(1.0 / 3.0)) < 2e-4);
}

TEST_CASE("wavelengths are drawn in their order and stay within the visible") {
  const Spectrum spectrum(ContinuousSpectrum{});
  double last = kVisibleFirst;
  for (const double u : {0x1p-53, 0.01, 0.3, 0.5, 0.7, 0.99, 1.0 - 0x1p-53}) {
    const SpectralSample sample = spectrum.sample(u);
    CHECK(sample.wavelength >= last);
    CHECK(sample.wavelength <= kVisibleLast);
    CHECK(sample.light == sample.xyz.y);
    // The colour is that wavelength's own: the ratios of the observer's responses.
    const Vec3 own = observer1931(sample.wavelength);
    CHECK(glm::length(glm::cross(glm::normalize(sample.xyz), glm::normalize(own))) < 0.02);
    last = sample.wavelength;
  }
}

TEST_CASE("spectral lines carry equal energy") {
  const std::vector<double> wavelengths = {450.0, 550.0, 650.0, 500.0};
  const Spectrum spectrum(LineSpectrum{wavelengths});
  CHECK(spectrum.colours() == 3);
  REQUIRE(spectrum.lines().size() == wavelengths.size());
  std::vector<double> counts(4, 0.0);
  Vec3 sum(0.0);
  for (int i = 0; i < 4000; ++i) {
    const SpectralSample sample = spectrum.sample((i + 0.5) / 4000);
    for (int k = 0; k < 4; ++k) counts[k] += sample.wavelength == wavelengths[k];
    CHECK(sample.light == 1.0);
    sum += sample.xyz / 4000.0;
  }
  for (const double count : counts) CHECK(count == 1000.0);
  CHECK(glm::distance(sum, spectrum.white()) < 1e-12);
  CHECK(spectrum.white().y == doctest::Approx(1.0).epsilon(1e-12));
  // Equal energies: colours in proportion to the observer's responses.
  const Vec3 blue = spectrum.lines()[0].xyz, green = spectrum.lines()[1].xyz;
  CHECK(blue.y / green.y == doctest::Approx(0.038 / 0.9949501).epsilon(1e-6));
}

TEST_CASE("spectral lines carry energies in proportion to their weights, whatever the unit") {
  const std::vector<double> wavelengths = {450.0, 550.0, 650.0};
  for (const double unit : {1.0, 1e-6, 1e6}) {
    const Spectrum spectrum(LineSpectrum{wavelengths, {1.0 * unit, 4.0 * unit, 1.0 * unit}});
    const auto& lines = spectrum.lines();
    REQUIRE(lines.size() == 3);
    CHECK(spectrum.bundleSize() == 3);
    CHECK(lines[1].light == doctest::Approx(2.0).epsilon(1e-14));
    CHECK(lines[0].light == doctest::Approx(0.5).epsilon(1e-14));
    Vec3 sum(0.0);
    for (const SpectralSample& line : lines) sum += line.xyz / 3.0;
    CHECK(glm::distance(sum, spectrum.white()) < 1e-12);
    CHECK(spectrum.white().y == doctest::Approx(1.0).epsilon(1e-12));
    // XYZ of a line: its weight times the observer's response.
    CHECK(lines[1].xyz.y / lines[0].xyz.y == doctest::Approx(4.0 * 0.9949501 / 0.038).epsilon(1e-6));
  }
}

TEST_CASE("equal weights give the bits of no weights") {
  const std::vector<double> wavelengths = {450.0, 550.0, 650.0};
  const Spectrum plain(LineSpectrum{wavelengths}), weighted(LineSpectrum{wavelengths, {2.0, 2.0, 2.0}});
  CHECK(plain.white() == weighted.white());
  for (int i = 0; i < 3; ++i) {
    CHECK(plain.lines()[i].xyz == weighted.lines()[i].xyz);
    CHECK(weighted.lines()[i].light == 1.0);
  }
}

TEST_CASE("weights that are not one for each line, or not above 0, are no spectrum") {
  const std::vector<double> wavelengths = {450.0, 550.0};
  for (const std::vector<double>& weights : std::vector<std::vector<double>>{
           {1.0}, {1.0, 2.0, 3.0}, {1.0, 0.0}, {1.0, -1.0}, {1.0, std::nan("")}, {1.0, HUGE_VAL}})
    CHECK_THROWS_AS(Spectrum(LineSpectrum{wavelengths, weights}), std::invalid_argument);
}

TEST_CASE("lines that nobody sees are no spectrum") {
  CHECK_THROWS_AS(Spectrum(LineSpectrum{}), std::invalid_argument);
  CHECK_THROWS_AS(Spectrum(LineSpectrum{std::vector<double>{300.0, 900.0}}), std::invalid_argument);
  CHECK_NOTHROW(Spectrum(LineSpectrum{std::vector<double>{300.0, 550.0}}));
}

TEST_CASE("monochromatic light has luminance only") {
  for (const Spectrum& spectrum :
       {Spectrum(MonochromaticSpectrum{589.0}), Spectrum(LineSpectrum{std::vector<double>{589.0}})}) {
    CHECK(spectrum.colours() == 1);
    CHECK(spectrum.white() == Vec3(1.0));
    for (const double u : {0.001, 0.5, 0.999}) {
      CHECK(spectrum.sample(u).wavelength == 589.0);
      CHECK(spectrum.sample(u).xyz == Vec3(1.0));
      CHECK(spectrum.sample(u).light == 1.0);
    }
  }
}

TEST_CASE("wavelengths are drawn so that the picture's channels have the least summed variance") {
  const Spectrum spectrum(ContinuousSpectrum{});
  const Vec3 mean = toRec709(spectrum.white());
  const double drawn = meanOf(spectrum,
                              [](const SpectralSample& s) {
                                const Vec3 rgb = toRec709(s.xyz);
                                return glm::dot(rgb, rgb);
                              }) -
                       glm::dot(mean, mean);

  const double uniform = summedVariance([](int) { return 1.0; });
  const double luminance = summedVariance([](int i) { return kSunExtraterrestrial[i] * kObserver1931[i].y; });
  const double least =
      summedVariance([](int i) { return glm::length(toRec709(kSunExtraterrestrial[i] * kObserver1931[i])); });
  MESSAGE("summed variance a ray: " << drawn << "; uniform wavelengths " << uniform << ", by luminance " << luminance);
  CHECK(drawn < 0.7 * uniform);
  CHECK(drawn < 0.7 * luminance);
  // The least that any density can reach.
  CHECK(drawn == doctest::Approx(least).epsilon(1e-3));
}
