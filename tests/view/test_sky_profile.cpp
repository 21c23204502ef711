// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>

#include "math/rotation.h"
#include "pictures.h"
#include "view/sky_profile.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

constexpr Projection kAll[] = {Projection::rectilinear,         Projection::fisheyeEqualArea,
                               Projection::fisheyeEquidistant,  Projection::fisheyeStereographic,
                               Projection::fisheyeOrthographic, Projection::equirectangular};

Camera camera(Projection projection, double fieldOfView = radians(100.0)) {
  CameraSettings settings;
  settings.projection = projection;
  settings.fieldOfView = projection == Projection::equirectangular ? 2.0 * kPi : fieldOfView;
  settings.azimuth = radians(12.0);
  settings.elevation = radians(31.0);
  settings.roll = radians(-7.0);
  settings.width = 480;
  settings.height = 360;
  return Camera(settings);
}

const Vec3 kToSun = skyDirection(0.0, radians(25.0));

/// A sky of a smooth function of the angle from the sun.
double ring(double angle) { return 1.0 + 0.5 * std::sin(6.0 * angle); }

/// Sampled at the pixels' middles; channels 1, 2 and 3 times the ring.
Image ringSky(const Camera& camera) {
  return light(camera.width(), camera.height(), [&](int c, int x, int y) {
    const auto toSky = camera.toSky(Vec2(x + 0.5, y + 0.5));
    return toSky ? (c + 1) * ring(angleBetween(*toSky, kToSun)) : 0.0;
  });
}

}  // namespace

TEST_CASE("the profile of a sky that depends on the angle from the sun alone is that function, in every projection") {
  const SkyProfileSettings settings{radians(2.0), radians(40.0), radians(1.0)};
  // Within a bin the function changes by up to its slope of 3 times half the bin; its mean over the bin differs from
  // its value in the middle by less than slope times half bin times the unevenness of the pixels in it, a pixel (some
  // 0.75 degrees at most here) over the bin's width, and by curvature, 18 bin^2 / 24.
  const double half = 0.5 * settings.bin, bound = 3.0 * half * 0.25 + 18.0 * settings.bin * settings.bin / 24.0;
  for (const Projection projection : kAll) {
    const Camera eye = camera(projection);
    for (const SkyProfileBin& bin : skyProfile(ringSky(eye), eye, kToSun, settings)) {
      INFO(nameOf(projection), " ", degrees(bin.from));
      REQUIRE(bin.pixels > 8);
      const double exact = ring(bin.from + half);
      CHECK(std::abs(bin.mean.x - exact) < bound);
      CHECK(bin.mean.y == doctest::Approx(2.0 * bin.mean.x).epsilon(1e-6));
      CHECK(bin.mean.z == doctest::Approx(3.0 * bin.mean.x).epsilon(1e-6));
    }
  }
}

TEST_CASE("a constant sky has a constant profile without an error") {
  const Camera eye = camera(Projection::rectilinear);
  const Image sky = light(480, 360, [](int, int, int) { return 0.25; });
  for (const SkyProfileBin& bin : skyProfile(sky, eye, kToSun, {})) {
    if (bin.pixels == 0) continue;
    CHECK(bin.luminance == doctest::Approx(0.25).epsilon(1e-12));
    CHECK(bin.error < 1e-8);
  }
}

TEST_CASE("every pixel that shows sky is in one bin") {
  for (const Projection projection : kAll) {
    const Camera eye = camera(projection);
    const Image sky = ringSky(eye);
    const auto bins = skyProfile(sky, eye, kToSun, {0.0, kPi, radians(0.7)});
    CHECK(bins.back().to == kPi);
    std::int64_t counted = 0, seen = 0;
    for (const SkyProfileBin& bin : bins) counted += bin.pixels;
    for (int y = 0; y < eye.height(); ++y)
      for (int x = 0; x < eye.width(); ++x) {
        bool all = true;
        for (const Vec2& corner : {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1), Vec2(1, 1)})
          all = all && eye.toSky(Vec2(x, y) + corner);
        seen += all;
      }
    CHECK(seen > 10000);
    CHECK(counted == seen);
  }
}

TEST_CASE("a pixel is in the bin of its centre") {
  for (const Projection projection : kAll) {
    const Camera eye = camera(projection);
    const double tenth = 0.1 / eye.focalLength();  // rad, a tenth of a pixel at the axis
    const Vec3 toMiddle = *eye.toSky(Vec2(240.5, 180.5));
    const auto bins = skyProfile(ringSky(eye), eye, toMiddle, {0.0, 4.0 * tenth, tenth});
    CHECK(bins[0].pixels == 1);
    for (std::size_t i = 1; i < 4; ++i) CHECK(bins[i].pixels == 0);
  }
}

TEST_CASE("pixels count by solid angle and by the mask") {
  // Above the horizon of an equirectangular picture the light is 1, below 0: from a sun on the horizon each bin has
  // half its solid angle on either side, though the rows near the poles have as many pixels as all others.
  CameraSettings settings;
  settings.projection = Projection::equirectangular;
  settings.elevation = 0.0;
  settings.fieldOfView = 2.0 * kPi;
  settings.width = 360;
  settings.height = 180;
  const Camera eye(settings);
  const auto strip = [](int y) { return y < 30 ? 1.0 : 0.0; };  // above 60 degrees
  const Image sky = light(360, 180, [&](int, int, int y) { return strip(y); });
  const SkyProfileSettings whole{0.0, kPi, kPi};
  const SkyProfileBin all = skyProfile(sky, eye, {1.0, 0.0, 0.0}, whole).at(0);
  const double share = 0.5 * (1.0 - std::sin(radians(60.0)));
  CHECK(all.luminance == doctest::Approx(share).epsilon(1e-3));

  std::vector<std::uint8_t> mask(360 * 180, 255);
  std::fill(mask.begin() + 360 * 30, mask.end(), std::uint8_t{51});
  const SkyProfileBin masked = skyProfile(sky, eye, {1.0, 0.0, 0.0}, whole, mask).at(0);
  CHECK(masked.luminance == doctest::Approx(share / (share + 0.2 * (1.0 - share))).epsilon(1e-3));
  std::fill(mask.begin() + 360 * 30, mask.end(), std::uint8_t{0});
  const SkyProfileBin strict = skyProfile(sky, eye, {1.0, 0.0, 0.0}, whole, mask).at(0);
  CHECK(strict.pixels == 360 * 30);
  CHECK(strict.luminance == doctest::Approx(1.0).epsilon(1e-12));
}

TEST_CASE("the standard error is the scatter of the mean") {
  const Camera eye = camera(Projection::fisheyeEqualArea);
  constexpr double kSigma = 0.1;
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0.0, kSigma);
  std::vector<double> values(480 * 360);
  for (double& value : values) value = 1.0 + noise(random);
  const Image sky = light(480, 360, [&](int, int x, int y) { return values[static_cast<std::size_t>(y * 480 + x)]; });
  int far = 0, bins = 0;
  for (const SkyProfileBin& bin : skyProfile(sky, eye, kToSun, {radians(2.0), radians(40.0), radians(0.5)})) {
    CHECK(bin.error == doctest::Approx(kSigma / std::sqrt(static_cast<double>(bin.pixels))).epsilon(0.25));
    ++bins;
    far += std::abs(bin.luminance - 1.0) > 2.0 * bin.error;
  }
  CHECK(bins == 76);
  CHECK(far <= 11);  // 4.6 % of 76 are 3.5, and 11 lies 4 standard deviations above that
}

TEST_CASE("pixels that are not finite do not count") {
  const Camera eye = camera(Projection::rectilinear);
  Image sky = light(480, 360, [](int, int, int) { return 1.0; });
  sky.channels[1].samples[480 * 180 + 240] = std::numeric_limits<float>::quiet_NaN();
  const SkyProfileBin all = skyProfile(sky, eye, kToSun, {0.0, kPi, kPi}).at(0);
  CHECK(all.pixels == 480 * 360 - 1);
  CHECK(all.luminance == doctest::Approx(1.0));
}

TEST_CASE("two cameras share the sky that both see") {
  const Camera wide = camera(Projection::fisheyeEqualArea), narrow = camera(Projection::rectilinear, radians(30.0));
  const auto inNarrow = sharedSky(narrow, {}, wide, {});
  CHECK(std::count(inNarrow.begin(), inNarrow.end(), 255) == 480 * 360);
  const auto inWide = sharedSky(wide, {}, narrow, {});
  double seen = 0.0, whole = 0.0;
  for (int y = 0; y < 360; ++y)
    for (int x = 0; x < 480; ++x) {
      seen += inWide[static_cast<std::size_t>(y * 480 + x)] ? wide.solidAngle(x, y) : 0.0;
      whole += narrow.solidAngle(x, y);
    }
  CHECK(seen == doctest::Approx(whole).epsilon(0.01));  // the border's pixels are 2 / 480 of each side
  // What the other's mask takes away is taken away here, too.
  const std::vector<std::uint8_t> nothing(480 * 360, 0);
  const auto none = sharedSky(wide, {}, narrow, nothing);
  CHECK(std::count(none.begin(), none.end(), 0) == 480 * 360);
}

TEST_CASE("profiles that cannot be are refused") {
  const Camera eye = camera(Projection::rectilinear);
  const Image sky = light(480, 360, [](int, int, int) { return 1.0; });
  for (const SkyProfileSettings& bad :
       {SkyProfileSettings{-0.1, 1.0, 0.1}, {1.0, 1.0, 0.1}, {0.0, 4.0, 0.1}, {0.0, 1.0, 0.0}, {0.0, 1.0, 1e-9}})
    CHECK_THROWS_AS(skyProfile(sky, eye, kToSun, bad), std::invalid_argument);
  CHECK_THROWS_AS(skyProfile(light(4, 4, [](int, int, int) { return 1.0; }), eye, kToSun, {}), std::invalid_argument);
  CHECK_THROWS_AS(skyProfile(sky, eye, kToSun, {}, std::vector<std::uint8_t>(5)), std::invalid_argument);
}
