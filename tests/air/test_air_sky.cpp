// SPDX-License-Identifier: Apache-2.0
#include "air/air_sky.h"

#include <cmath>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "light_walk.h"
#include "optics/illuminants.h"
#include "optics/tables.h"
#include "parallel/threads.h"
#include "statistics.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

Vec3 toward(double elevation, double azimuth) {
  const double e = radians(elevation), a = radians(azimuth);
  return {std::cos(e) * std::cos(a), -std::cos(e) * std::sin(a), std::sin(e)};
}

struct Place {
  double elevation, azimuth;  // degrees
};

struct Estimate {
  double mean, error;
};

Estimate walked(const LightWalk& walk, const Vec3& direction, int paths) {
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < paths; ++i) {
    RandomStream random(1, static_cast<std::uint64_t>(i), RandomPurpose::pilot);
    const double light = walk.path(kEyeHeight, direction, random).all;
    sum += light;
    squares += light * light;
  }
  const double mean = sum / paths;
  return {mean, std::sqrt((squares / paths - mean * mean) / paths)};
}

/// The sky against walks of so many paths, which it must meet within `bound`, relative, and their noise.
void checkAgainstWalks(const SkySettings& settings, double wavelength, double sun, const std::vector<Place>& places,
                       double bound, int paths = 10000) {
  const LightBands light = oneWavelength(wavelength);
  const AirSky sky(settings, 0.0, radians(sun), light);
  const LightWalk walk(settings, wavelength, radians(sun));
  for (const auto& [elevation, azimuth] : places) {
    const Vec3 direction = toward(elevation, azimuth);
    const Estimate estimate = walked(walk, direction, paths);
    CAPTURE(settings.ground);
    CAPTURE(wavelength);
    CAPTURE(sun);
    CAPTURE(elevation);
    CAPTURE(azimuth);
    const double ours = sky.radiance(direction).y;
    CHECK(std::abs(ours - estimate.mean) <= bound * estimate.mean + kSigmas * estimate.error);
  }
}

/// Irradiance of a level surface by what `sky` shows above (side 1) or below (side -1), over the sphere by midpoints.
Vec3 irradiance(const AirSky& sky, double side) {
  constexpr int kSines = 400, kTurns = 90;
  Vec3 sum(0.0);
  for (int i = 0; i < kSines; ++i) {
    const double z = (i + 0.5) / kSines, level = std::sqrt(1.0 - z * z);
    for (int j = 0; j < kTurns; ++j) {
      const double turn = kPi * (j + 0.5) / kTurns;
      sum += z * sky.radiance({level * std::cos(turn), level * std::sin(turn), side * z});
    }
  }
  return sum * (2.0 * kPi / (kSines * kTurns));
}

Vec2 uvOf(const Vec3& xyz) {  // CIE 1960
  const double sum = xyz.x + 15.0 * xyz.y + 3.0 * xyz.z;
  return {4.0 * xyz.x / sum, 6.0 * xyz.y / sum};
}

/// Correlated colour temperature, kelvin: of the black body nearest in the CIE 1960 diagram, on a grid of half a
/// percent.
double temperatureOf(const Vec3& xyz) {
  const Vec2 own = uvOf(xyz);
  double best = 0.0, nearest = INFINITY;
  for (double t = 1500.0; t < 200000.0; t *= 1.005) {
    Vec3 body(0.0);
    for (int i = 0; i < kVisibleNodes; i += 5)
      body += blackBody(t, kVisibleFirst + i) * kObserver1931[static_cast<std::size_t>(i)];
    const Vec2 off = uvOf(body) - own;
    const double distance = off.x * off.x + off.y * off.y;
    if (distance < nearest) {
      nearest = distance;
      best = t;
    }
  }
  return best;
}

SkySettings clean(double beta = 0.03) {
  SkySettings settings;
  settings.aerosol.beta = beta;
  return settings;
}

}  // namespace

TEST_CASE("in thin air the sky is that of single scattering through spherical shells") {
  SkySettings thin;
  thin.ozone = thin.aerosol.beta = thin.ground = 0.0;
  // The depth is 0.018: what is scattered twice is a hundredth, but for the horizon.
  checkAgainstWalks(thin, 830.0, 30.0, {{90, 0}, {30, 20}, {10, 120}}, 0.01, 100000);
  checkAgainstWalks(thin, 830.0, -3.0, {{60, 0}, {20, 20}}, 0.02, 100000);
}

TEST_CASE("the sky meets random walks of light within 13 %, with the sun on the horizon within 20 %") {
  const std::vector<Place> places{{90, 0}, {30, 30}, {30, 150}, {2, 0}, {2, 90}, {0.3, 180}};
  for (const double ground : {0.15, 0.8})
    for (const double wavelength : {420.0, 550.0}) {
      SkySettings settings;
      settings.ground = ground;
      for (const double sun : {5.0, 20.0, 60.0}) checkAgainstWalks(settings, wavelength, sun, places, 0.13);
      checkAgainstWalks(settings, wavelength, 0.5, places, 0.20);
    }
}

TEST_CASE("the ground as it is seen meets random walks of light within 5 %") {
  for (const double ground : {0.15, 0.8}) {
    SkySettings settings;
    settings.ground = ground;
    for (const double sun : {5.0, 60.0}) checkAgainstWalks(settings, 550.0, sun, {{-20, 40}, {-80, 0}}, 0.05);
  }
}

TEST_CASE("air that absorbs nothing sends all light down or back up, within 3 %") {
  SkySettings settings;
  settings.ozone = settings.ground = 0.0;
  settings.aerosol.albedo = 1.0;
  const Atmosphere air(settings);
  for (const double wavelength : {420.0, 550.0, 700.0})
    for (const double sun : {30.0, 70.0}) {
      const LightBands light = oneWavelength(wavelength);
      const double top = 60.0, sine = std::sin(radians(sun));
      const double direct = air.sunTransmittance(wavelength, 0.0, radians(sun)) * sine;
      const double down = irradiance(AirSky(settings, 0.0, radians(sun), light), 1.0).y;
      const double up = irradiance(AirSky(settings, top, radians(sun), light), -1.0).y;
      const double larger = (kGroundRadius + top) / kGroundRadius;  // of the shell through which light leaves
      CAPTURE(wavelength);
      CAPTURE(sun);
      CHECK(std::abs((direct + down + larger * larger * up) / sine - 1.0) < 0.03);
    }
}

TEST_CASE("the ground is as bright as the sunlight and the sky above it make it") {
  for (const double sun : {3.0, 20.0, 60.0}) {
    const AirSky sky(clean(), 0.0, radians(sun));
    const double lit = sky.sunlight().y * std::sin(radians(sun)) + irradiance(sky, 1.0).y;
    CHECK(sky.radiance({0.0, 0.0, -1.0}).y * kPi / clean().ground == doctest::Approx(lit).epsilon(0.06));
  }
}

TEST_CASE("luminances of clear skies are those that have been measured") {
  // One aerosol does not give all of them at once: the ranges are over clear days.
  struct Measured {
    double sun, beta, least, most;  // degrees; cd/m^2 at the zenith
  };
  for (const Measured& m : {Measured{20, 0.02, 1e3, 2e3},
                            {20, 0.08, 1e3, 2e3},
                            {45, 0.06, 3e3, 5e3},
                            {45, 0.1, 3e3, 5e3},
                            {60, 0.06, 5e3, 10e3},
                            {60, 0.08, 6e3, 10e3}}) {
    const AirSky sky(clean(m.beta), 0.0, radians(m.sun));
    const double zenith = sky.radiance({0.0, 0.0, 1.0}).y;
    CAPTURE(m.sun);
    CAPTURE(m.beta);
    CHECK(zenith > m.least);
    CHECK(zenith < m.most);
  }
  for (const double sun : {5.0, 20.0, 45.0})
    for (const double beta : {0.02, 0.05}) {
      const AirSky sky(clean(beta), 0.0, radians(sun));
      const double share = sky.radiance(toward(1.0, 90.0)).y / sky.radiance({0.0, 0.0, 1.0}).y;
      CHECK(share > 1.5);
      CHECK(share < 8.0);
    }
}

TEST_CASE(
    "the sky a quarter turn from the sun is of 15 to 40 thousand kelvin, the sun of 5500 when high, 2 to 3 thousand at "
    "2 degrees") {
  CHECK(temperatureOf(AirSky(clean(0.02), 0.0, radians(5.0)).radiance({0.0, 0.0, 1.0})) > 15e3);
  for (const double sun : {20.0, 45.0, 70.0}) {
    const double sky = temperatureOf(AirSky(clean(0.05), 0.0, radians(sun)).radiance(toward(90.0 - sun, 180.0)));
    CAPTURE(sun);
    CHECK(sky > 15e3);
    CHECK(sky < 40e3);
  }
  const auto ofSun = [](double beta, double sun) {
    return temperatureOf(AirSky(clean(beta), 0.0, radians(sun)).sunlight());
  };
  CHECK(ofSun(0.02, 70.0) == doctest::Approx(5500.0).epsilon(0.05));
  for (const double beta : {0.02, 0.03}) {
    CHECK(ofSun(beta, 2.0) > 2000.0);
    CHECK(ofSun(beta, 2.0) < 3000.0);
  }
}

TEST_CASE("direct sunlight is 100 to 120 klx when high, 30 klx at 10 degrees and 5 to 10 klx at 4") {
  const auto light = [](double beta, double sun) { return AirSky(clean(beta), 0.0, radians(sun)).sunlight().y; };
  for (const double beta : {0.02, 0.05}) {
    CHECK(light(beta, 70.0) > 100e3);
    CHECK(light(beta, 70.0) < 120e3);
  }
  CHECK(light(0.06, 10.0) == doctest::Approx(30e3).epsilon(0.15));
  CHECK(light(0.05, 4.0) > 5e3);
  CHECK(light(0.05, 4.0) < 10e3);
}

TEST_CASE("at the horizon sunlight is 1/25, 1/600 and 1/60,000 of the zenith's for beta 0, 0.02 and 0.05") {
  for (const auto& [beta, share] : {std::pair{0.0, 25.0}, {0.02, 600.0}, {0.05, 60000.0}}) {
    const AirSky sky(clean(beta), 0.0, 0.1);
    // Rounded figures, and steep: the eye is 2 m up, where the air at the horizon is a little more.
    CHECK(sky.sunlightFrom(radians(90.0)).y / sky.sunlightFrom(0.0).y == doctest::Approx(share).epsilon(0.25));
  }
}

TEST_CASE("nothing jumps while the sun sets, until it is 6 degrees down") {
  const std::vector<Place> places{{90, 0}, {1, 0}, {1, 180}, {20, 60}, {-30, 0}};
  std::vector<double> before, slopes;
  for (int tenth = 20; tenth >= -60; --tenth) {
    const AirSky sky(clean(), 0.0, radians(0.1 * tenth));
    for (std::size_t k = 0; k < places.size(); ++k) {
      const double light = std::log(sky.radiance(toward(places[k].elevation, places[k].azimuth)).y);
      CAPTURE(tenth);
      CAPTURE(k);
      if (tenth == 20) {
        before.push_back(light);
        slopes.push_back(0.0);
        continue;
      }
      const double slope = light - before[k];
      // Between two tenths of a degree the light changes by at most a fifth, and evenly.
      CHECK(std::abs(slope) < 0.2);
      if (tenth < 19) CHECK(std::abs(slope - slopes[k]) < 0.03);
      before[k] = light;
      slopes[k] = slope;
    }
  }
}

TEST_CASE("the zenith of twilight is blue by ozone") {
  SkySettings without;
  without.ozone = 0.0;
  const auto blue = [](const SkySettings& settings) {
    const Vec3 xyz = AirSky(settings, 0.0, radians(-4.0)).radiance({0.0, 0.0, 1.0});
    return xyz.z / xyz.y;
  };
  CHECK(blue(SkySettings{}) > 1.3 * blue(without));
}

TEST_CASE("the sky is its own mirror image, and has the same bits for any number of threads") {
  const SkySettings settings;
  const AirSky one = withThreads(1, [&] { return AirSky(settings, 0.3, radians(12.0)); });
  const AirSky four = withThreads(4, [&] { return AirSky(settings, 0.3, radians(12.0)); });
  for (double elevation = -88.0; elevation < 90.0; elevation += 7.3)
    for (double azimuth = 3.0; azimuth < 180.0; azimuth += 11.0) {
      CHECK(one.radiance(toward(elevation, azimuth)) == four.radiance(toward(elevation, azimuth)));
      CHECK(one.radiance(toward(elevation, azimuth)) == one.radiance(toward(elevation, -azimuth)));
    }
}

TEST_CASE("from an aircraft the horizon lies lower and the sky above is darker") {
  const AirSky low(clean(), 0.0, radians(30.0)), high(clean(), 10.0, radians(30.0));
  CHECK(degrees(high.horizon()) == doctest::Approx(-degrees(std::acos(6371.0 / 6381.0))).epsilon(1e-3));
  CHECK(high.radiance({0.0, 0.0, 1.0}).y < 0.5 * low.radiance({0.0, 0.0, 1.0}).y);
  CHECK(high.sunlight().y > low.sunlight().y);
}
