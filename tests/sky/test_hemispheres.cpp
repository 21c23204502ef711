// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>

#include <glm/geometric.hpp>

#include "math/names.h"
#include "math/rotation.h"
#include "sky/camera.h"
#include "sky/isotropic_light.h"
#include "sky/look_at.h"
#include "sky/picture_parts.h"

namespace parhelion {
namespace {

constexpr std::array kDual = {Projection::dualFisheyeEqualArea, Projection::dualFisheyeEquidistant,
                              Projection::dualFisheyeStereographic, Projection::dualFisheyeOrthographic};
constexpr std::array kAll = {kDual[0], kDual[1], kDual[2], kDual[3], Projection::globe};

/// Turned in no special way.
CameraSettings turned(Projection projection, int width, int height) {
  return test::lookAt(projection, 40.0, -23.0, 63.0, 180.0, width, height);
}

double total(const Camera& camera) {
  const std::vector<double> all = camera.solidAngles();
  return std::accumulate(all.begin(), all.end(), 0.0);
}

Vec2 placeOf(const Camera& camera, double azimuth, double elevation) {
  const auto place = camera.project(skyDirection(radians(azimuth), radians(elevation)));
  REQUIRE(place);
  return *place;
}

void checkNear(const Vec2& a, double x, double y) {
  CHECK(a.x == doctest::Approx(x).epsilon(1e-9));
  CHECK(a.y == doctest::Approx(y).epsilon(1e-9));
}

}  // namespace

TEST_CASE("every place in a picture of hemispheres goes to the sky and back") {
  for (const Projection projection : kAll) {
    CAPTURE(std::string(nameOf(projection)));
    const Camera camera(turned(projection, projection == Projection::globe ? 300 : 600, 300));
    std::mt19937 random(1);
    std::uniform_real_distribution<double> x(0.0, camera.width()), y(0.0, camera.height());
    int seen = 0;
    for (int i = 0; i < 4000; ++i) {
      const Vec2 place{x(random), y(random)};
      const auto toSky = camera.toSky(place);
      if (!toSky) continue;
      ++seen;
      CHECK(std::abs(glm::length(*toSky) - 1.0) < 1e-12);
      const auto back = camera.project(*toSky);
      REQUIRE(back);
      CHECK(glm::length(*back - place) < 1e-4);  // at an orthographic rim a place hangs on the root of rounding
    }
    // Discs in squares: pi / 4 of them, 5 sigma of 4000 tries.
    CHECK(std::abs(seen / 4000.0 - 0.25 * kPi) < 5.0 * std::sqrt(0.17 / 4000.0));
  }
}

TEST_CASE("the pixels of a dual fisheye add up to the sphere, those of a globe to half of it") {
  for (const auto& [width, height] : {std::pair(2, 1), {2, 2}, {6, 3}, {14, 7}, {128, 64}, {600, 302}, {200, 400}}) {
    CAPTURE(width);
    for (const Projection projection : kDual) {
      CAPTURE(std::string(nameOf(projection)));
      CHECK(total(Camera(turned(projection, width, height))) == doctest::Approx(4.0 * kPi).epsilon(1e-11));
    }
    CHECK(total(Camera(turned(Projection::globe, width, height))) == doctest::Approx(2.0 * kPi).epsilon(1e-11));
  }
}

TEST_CASE("isotropic light falls into each pixel of hemispheres by its solid angle, up to the rim") {
  for (const Projection projection : kAll) {
    CAPTURE(std::string(nameOf(projection)));
    const Camera camera(turned(projection, projection == Projection::globe ? 20 : 40, 20));
    test::checkIsotropicLight(camera, [](const Vec3&, std::optional<int>) {});
  }
}

TEST_CASE("a dual fisheye shows what is before the camera at the left and what is behind it at the right") {
  for (const Projection projection : kDual) {
    CAPTURE(std::string(nameOf(projection)));
    const Camera level(test::lookAt(projection, 0.0, 0.0, 0.0, 180.0, 400, 200));
    checkNear(placeOf(level, 0.0, 0.0), 100.0, 100.0);
    checkNear(placeOf(level, 180.0, 0.0), 300.0, 100.0);
    // The zenith is at the top of both, an observer's right at the right of both, and where they touch is one place.
    CHECK(placeOf(level, 0.0, 60.0).y < 100.0);
    CHECK(placeOf(level, 180.0, 60.0).y < 100.0);
    CHECK(placeOf(level, 30.0, 0.0).x > 100.0);
    CHECK(placeOf(level, -150.0, 0.0).x > 300.0);
    checkNear(placeOf(level, 89.9999999, 0.0), 200.0, 100.0);
    checkNear(placeOf(level, 90.0000001, 0.0), 200.0, 100.0);

    const Camera up(test::lookAt(projection, 0.0, 90.0, 0.0, 180.0, 400, 200));
    checkNear(placeOf(up, 0.0, 90.0), 100.0, 100.0);
    checkNear(placeOf(up, 0.0, -90.0), 300.0, 100.0);
    // The sun's azimuth is at the bottom of both.
    CHECK(placeOf(up, 0.0, 10.0).y > 150.0);
    CHECK(placeOf(up, 0.0, -10.0).y > 150.0);
    CHECK(placeOf(up, 0.0, -10.0).x == doctest::Approx(300.0));
  }
}

TEST_CASE("the halves of a dual fisheye are pictures of ordinary fisheyes") {
  for (const Projection projection : kDual) {
    for (const auto& [width, height] : {std::pair(400, 200), {400, 300}, {600, 200}}) {
      CAPTURE(std::string(nameOf(projection)));
      const CameraSettings settings = turned(projection, width, height);
      const Camera whole(settings);
      const std::vector<PicturePart> parts = partsOf(settings);
      REQUIRE(parts.size() == 2);
      const Camera halves[] = {Camera(parts[0].camera), Camera(parts[1].camera)};
      for (double y = 3.3; y < height; y += 17.0) {
        for (double x = 2.7; x < width; x += 13.0) {
          const std::size_t side = 2.0 * x < width ? 0 : 1;
          const auto one = whole.toSky({x, y}), other = halves[side].toSky({x - parts[side].left, y});
          REQUIRE(one.has_value() == other.has_value());
          if (one) CHECK(glm::length(*one - *other) < 1e-7);
        }
      }
    }
  }
  CHECK(partsOf(turned(Projection::globe, 10, 10)).size() == 1);
}

TEST_CASE("a globe shows the near side of the sky from outside, left and right changed over") {
  const Camera camera(test::lookAt(Projection::globe, 0.0, 20.0, 0.0, 180.0, 300, 200));
  checkNear(placeOf(camera, 0.0, 20.0), 150.0, 100.0);
  CHECK(placeOf(camera, 30.0, 20.0).x < 150.0);   // an observer's right
  CHECK(placeOf(camera, -30.0, 20.0).x > 150.0);  // and left
  CHECK(placeOf(camera, 0.0, 90.0).y < 100.0);
  CHECK_FALSE(camera.project(skyDirection(kPi, 0.0)));  // the far side
  // Inside out and left for right: that of an orthographic fisheye, mirrored.
  const Camera inside(test::lookAt(Projection::fisheyeOrthographic, 0.0, 20.0, 0.0, 180.0, 200, 200));
  for (const auto& [azimuth, elevation] : {std::pair(25.0, -30.0), {-60.0, 5.0}, {130.0, 80.0}}) {
    const Vec2 from = placeOf(inside, azimuth, elevation), to = placeOf(camera, azimuth, elevation);
    checkNear(to, 150.0 - (from.x - 100.0), from.y);
  }
  // A clockwise turn of the viewer's camera turns the globe the other way: what was at the top is at the left.
  const Camera rolled(test::lookAt(Projection::globe, 0.0, 0.0, 90.0, 180.0, 200, 200));
  CHECK(placeOf(rolled, 0.0, 80.0).x < 10.0);
}

TEST_CASE("a dual fisheye is no mirror image of itself left for right, a globe is") {
  CHECK_FALSE(Camera(test::lookAt(kDual[0], 0.0, 0.0, 0.0, 180.0, 40, 20)).isMirrorSymmetric());
  CHECK(Camera(test::lookAt(Projection::globe, 0.0, 20.0, 0.0, 180.0)).isMirrorSymmetric());
}

TEST_CASE("what hemispheres leave no choice of is refused") {
  for (const Projection projection : kAll) {
    CAPTURE(std::string(nameOf(projection)));
    CameraSettings s = turned(projection, 40, 20);
    CHECK_NOTHROW(Camera{s});
    s.fieldOfView = radians(100.0);
    CHECK_THROWS_AS(Camera{s}, std::invalid_argument);
    s = turned(projection, 40, 20);
    s.imageCircle = radians(180.0);
    CHECK_THROWS_AS(Camera{s}, std::invalid_argument);
    s = turned(projection, 40, 20);
    s.distortion.k1 = 0.01;
    CHECK_THROWS_AS(Camera{s}, std::invalid_argument);
  }
  CHECK_THROWS_AS(Camera{turned(kDual[0], 41, 20)}, std::invalid_argument);
  CHECK_NOTHROW(Camera{turned(Projection::globe, 41, 20)});
}

}  // namespace parhelion
