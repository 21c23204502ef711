// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "math/rotation.h"
#include "photo/sky_match.h"
#include "picture/colour_space.h"

namespace parhelion {
namespace {

constexpr int kWidth = 300, kHeight = 200;
constexpr double kSunElevation = radians(15.0);

CameraSettings lens() {
  CameraSettings settings;
  settings.projection = Projection::rectilinear;
  settings.fieldOfView = radians(60.0);
  settings.elevation = kSunElevation;
  settings.width = kWidth;
  settings.height = kHeight;
  return settings;
}

/// Luminance by the angle from a place and by the place in the picture.
using Light = std::function<double(double angle, Vec2 place)>;

/// The sky's measured luminance in a grey picture whose light is about a centre `off` (rad) to the right of the sun.
double measured(const Light& light, double off = 0.0) {
  const Camera camera(lens());
  const Vec3 centre = skyDirection(off, kSunElevation);
  Photograph photograph;
  photograph.width = kWidth;
  photograph.height = kHeight;
  std::vector<float> samples;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const Vec2 place{x + 0.5, y + 0.5};
      const double angle = angleBetween(camera.toSky(place).value(), centre);
      samples.insert(samples.end(), 3, static_cast<float>(light(angle, place)));
    }
  }
  photograph.samples = std::move(samples);
  const SkyMask sky{kWidth, kHeight, std::vector<std::uint8_t>(photograph.pixels(), 255)};
  return skyTone(photograph, sky, lens(), kSunElevation).luminance;
}

/// A sky that is a third brighter at one side than at the other.
double plainSky(Vec2 place) { return 0.3 + 0.1 * place.x / kWidth; }

constexpr double kDisc = radians(0.7);  // radius, some pixels wide

}  // namespace

TEST_CASE("the sun's disc is not sky, wherever it is, however bright and with what it does not hold as numbers") {
  const double without = measured([](double, Vec2 place) { return plainSky(place); });
  CHECK(without == doctest::Approx(0.35).epsilon(1e-3));
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double disc : {5.0, 1e3, 6e4, 1e9, kInfinity, std::nan("")}) {
    for (const double off : {0.0, radians(2.0), radians(12.0)}) {
      CAPTURE(disc);
      CAPTURE(off);
      const auto light = [disc](double angle, Vec2 place) { return angle < kDisc ? disc : plainSky(place); };
      // A disc takes less than a thousandth of the sky away.
      CHECK(measured(light, off) == doctest::Approx(without).epsilon(1e-3));
    }
  }
}

TEST_CASE("of the glare about a disc that is partly clipped no more is sky than what is as bright as it") {
  const double without = measured([](double, Vec2 place) { return plainSky(place); });
  const auto glare = [](double clip) {
    return [clip](double angle, Vec2 place) {
      const double bright = plainSky(place) + 300.0 * std::exp(-angle / radians(0.8));
      return std::min(angle < kDisc ? 1e5 : bright, clip);
    };
  };
  // Glare up to the sky's own light remains: 2 pi r w on the sky of 2700 square degrees, with w = 0.8 degrees and r
  // = 6.
  for (const double clip : {1e9, 100.0, 5.0}) CHECK(measured(glare(clip)) == doctest::Approx(without).epsilon(0.02));
}

TEST_CASE("lamps are not sky, and clouds before a dark sky are") {
  const double without = measured([](double, Vec2 place) { return plainSky(place); });
  const auto lamps = [](double, Vec2 place) {
    const double d = std::min(glm::length(place - Vec2(80.0, 50.0)), glm::length(place - Vec2(220.0, 150.0)));
    return plainSky(place) + 2e4 / (1.0 + d * d * d * d);
  };
  CHECK(measured(lamps) == doctest::Approx(without).epsilon(0.01));

  const auto clouds = [](double, Vec2 place) { return place.x < 0.25 * kWidth ? 0.8 : 0.1; };
  CHECK(measured(clouds) > 0.2);
}

TEST_CASE("a black sky with few lights has the brightness of these") {
  const auto stars = [](double, Vec2 place) { return place.x < 30.0 ? 0.5 : 0.0; };
  CHECK(measured(stars) > 0.01);
}

}  // namespace parhelion
