// SPDX-License-Identifier: Apache-2.0
#include "air/atmosphere.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <doctest/doctest.h>

#include "air/sun_masses.h"
#include "math/conventions.h"
#include "optics/tables.h"

using namespace parhelion;

namespace {

const Atmosphere kAir{SkySettings{}};

/// Elevation at which a plane atmosphere would have so many air masses.
double elevationOf(double masses) { return std::asin(1.0 / masses); }

}  // namespace

TEST_CASE("Rayleigh's vertical depth is 0.360, 0.0973 and 0.0365 at 400, 550 and 700 nm") {
  for (const auto& [wavelength, depth] : {std::pair{400.0, 0.360}, {550.0, 0.0973}, {700.0, 0.0365}})
    CHECK(std::abs(kAir.depths(wavelength).rayleigh / depth - 1.0) < 0.01);
}

TEST_CASE("300 Dobson units of ozone have a depth of 0.0405 near 600 nm") {
  CHECK(std::abs(kAir.depths(605.0).ozone / 0.0405 - 1.0) < 0.01);
  SkySettings twice;
  twice.ozone *= 2.0;
  CHECK(std::abs(Atmosphere(twice).depths(605.0).ozone / kAir.depths(605.0).ozone - 2.0) < 1e-12);
}

TEST_CASE("the aerosol's depth follows Angstrom's law") {
  CHECK(std::abs(kAir.depths(500.0).aerosol / (0.03 * std::pow(0.5, -1.3)) - 1.0) < 1e-12);
}

TEST_CASE("a vertical path has one air mass of each constituent") {
  const OfAir masses = kAir.massesToSpace(RayPlace::at(0.0, 0.5 * kPi));
  // The air ends at 100 km, above which are 4e-6 of it.
  CHECK(masses.rayleigh == doctest::Approx(1.0).epsilon(1e-5));
  CHECK(masses.ozone == doctest::Approx(1.0).epsilon(1e-9));
  CHECK(masses.aerosol == doctest::Approx(1.0).epsilon(1e-5));
}

TEST_CASE("straight rays at the horizon have 35.4, 81.7 and 11.6 air masses of molecules, aerosol and ozone") {
  const OfAir masses = kAir.massesToSpace(RayPlace::at(0.0, 0.0));
  CHECK(std::abs(masses.rayleigh - 35.4) < 0.05);
  CHECK(std::abs(masses.aerosol - 81.7) < 0.05);
  CHECK(std::abs(masses.ozone - 11.6) < 0.05);
}

TEST_CASE("air masses are what small steps along the ray add up to, also where it first goes down") {
  for (const auto& [altitude, elevation] : {std::pair{0.0, 7.0}, {12.0, -1.5}, {0.5, 0.3}, {30.0, -3.0}}) {
    const RayPlace place = RayPlace::at(altitude, radians(elevation));
    const double length = place.distanceUpTo(kAirTop);
    constexpr int kSteps = 200000;
    OfAir sum;
    for (int i = 0; i < kSteps; ++i) {
      const OfAir density = kAir.densities(place.after((i + 0.5) / kSteps * length).altitude());
      sum.rayleigh += density.rayleigh * length / kSteps;
      sum.ozone += density.ozone * length / kSteps;
      sum.aerosol += density.aerosol * length / kSteps;
    }
    const OfAir masses = kAir.massesToSpace(place);
    CHECK(masses.rayleigh == doctest::Approx(sum.rayleigh).epsilon(1e-4));
    CHECK(masses.ozone == doctest::Approx(sum.ozone).epsilon(1e-4));
    CHECK(masses.aerosol == doctest::Approx(sum.aerosol).epsilon(1e-4));
  }
}

TEST_CASE(
    "the table of the sun's air masses gives transmittances within two thousandths, near the horizon two hundredths") {
  const SunMasses table(kAir);
  const LightBands& bands = sunBands();
  const AirSpectrum spectrum(kAir, bands, ForwardLight::scattered);
  for (double altitude = 0.0; altitude < 40.0; altitude += 0.37)
    for (double elevation = 0.0; elevation < 90.0; elevation += 0.73) {
      const SunPlace place(altitude, std::sin(radians(elevation)));
      const Spectral near = spectrum.transmittance(table.at(place));
      const Spectral exact = spectrum.transmittance(kAir.massesToSpace(RayPlace::at(altitude, radians(elevation))));
      const double bound = elevation < 3.0 ? 0.02 : 0.002;
      for (std::size_t b = 0; b < kBands; ++b) CHECK(std::abs(near[b] - exact[b]) <= bound * exact[b] + 1e-6);
    }
}

TEST_CASE("at air mass 1.5 direct sunlight is that of ASTM G173 within 2 % beside the bands of water and oxygen") {
  SkySettings settings;
  settings.ozone = 344.0;
  settings.aerosol.beta = 0.084 * std::pow(0.5, settings.aerosol.alpha);  // 0.084 at 500 nm
  const Atmosphere air(settings);
  int compared = 0;
  for (int i = 0; i < kVisibleNodes; ++i) {
    const int wavelength = kVisibleFirst + i;
    constexpr std::pair<int, int> kBands[] = {{565, 600}, {620, 635}, {645, 666}, {685, 740}, {757, 772}, {785, 830}};
    if (std::ranges::any_of(kBands, [&](auto band) { return wavelength >= band.first && wavelength <= band.second; }))
      continue;
    const auto node = static_cast<std::size_t>(i);
    const double ours = kSunExtraterrestrial[node] * air.transmittance(wavelength, 0.0, elevationOf(1.5));
    const double off = ours / kSunAirMass1_5[node] - 1.0;
    CAPTURE(wavelength);
    CHECK(std::abs(off) < 0.02);
    ++compared;
  }
  CHECK(compared > 250);
}

TEST_CASE("the earth hides the sun below the horizon, which is lower for who stands higher") {
  CHECK(kAir.sunTransmittance(550.0, 0.0, radians(-0.3)) == 0.0);
  CHECK(kAir.sunTransmittance(550.0, 10.0, radians(-2.5)) > 0.0);
  CHECK(kAir.sunTransmittance(550.0, 10.0, radians(-3.6)) == 0.0);
  CHECK(kAir.transmittance(550.0, 0.0, radians(-0.1)) == 0.0);
  // Half of the disc is above the horizon.
  CHECK(std::abs(kAir.sunTransmittance(700.0, 0.0, 0.0) / kAir.transmittance(700.0, 0.0, 0.0) - 0.5) < 1e-9);
}

TEST_CASE("sunlight fades without a step as the sun sets") {
  SkySettings settings;
  settings.aerosol.beta = 0.0;  // so that much is left at the horizon
  const Atmosphere air(settings);
  double before = air.sunTransmittance(650.0, 0.0, radians(1.0));
  for (double elevation = 0.99; elevation > -0.4; elevation -= 0.01) {
    const double now = air.sunTransmittance(650.0, 0.0, radians(elevation));
    CHECK(now <= before);
    CHECK(before - now < 0.008);
    before = now;
  }
  CHECK(before == 0.0);
}

TEST_CASE("attenuations are exponentials within 1e-11") {
  for (int k = 0; k < 2000; ++k) {
    Spectral depth;
    for (std::size_t b = 0; b < kBands; ++b) depth[b] = 0.0173 * k + 0.31 * double(b);
    const Spectral through = attenuation(depth);
    for (std::size_t b = 0; b < kBands; ++b) CHECK(std::abs(through[b] / std::exp(-depth[b]) - 1.0) < 1e-11);
  }
}
