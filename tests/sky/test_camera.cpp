// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>

#include "math/rotation.h"
#include "picture/image.h"
#include "sky/camera.h"
#include "sky/look_at.h"

namespace parhelion {
namespace {

constexpr std::array kProjections = {Projection::rectilinear,         Projection::fisheyeEqualArea,
                                     Projection::fisheyeEquidistant,  Projection::fisheyeStereographic,
                                     Projection::fisheyeOrthographic, Projection::equirectangular};

CameraSettings settings(Projection projection, double fovDegrees, int width, int height) {
  return test::lookAt(projection, 0.0, 0.0, 0.0, fovDegrees, width, height);
}

Vec2 at(const Camera& camera, double azimuthDegrees, double elevationDegrees) {
  const auto p = camera.project(skyDirection(radians(azimuthDegrees), radians(elevationDegrees)));
  REQUIRE(p.has_value());
  return *p;
}

double widest(Projection p) {
  switch (p) {
    case Projection::rectilinear:
      return 120.0;
    case Projection::fisheyeOrthographic:
      return 180.0;
    case Projection::fisheyeStereographic:
      return 300.0;
    default:
      return 360.0;
  }
}

}  // namespace

TEST_CASE("every place in the picture goes to the sky and back") {
  std::mt19937 random(1);
  for (const Projection projection : kProjections) {
    CAPTURE(std::string(nameOf(projection)));
    CameraSettings s = settings(projection, 0.9 * widest(projection), 640, 480);
    s.azimuth = 0.7;
    s.elevation = -0.4;
    s.roll = 1.1;
    const Camera camera(s);
    std::uniform_real_distribution<double> x(0.0, 640.0), y(0.0, 480.0);
    int seen = 0;
    for (int i = 0; i < 2000; ++i) {
      const Vec2 place{x(random), y(random)};
      const auto sky = camera.toSky(place);
      if (!sky) continue;
      ++seen;
      CHECK(glm::length(*sky) == doctest::Approx(1.0).epsilon(1e-14));
      const auto back = camera.project(*sky);
      REQUIRE(back.has_value());
      CHECK(glm::length(*back - place) < 2e-9);  // pixels
      CHECK(camera.pixelAt(*sky) == static_cast<int>(back->y) * 640 + static_cast<int>(back->x));
    }
    CHECK(seen > 500);
  }
}

TEST_CASE("every direction of the sky goes to the picture and back, close to the axis too") {
  std::mt19937 random(2);
  std::normal_distribution<double> normal;
  for (const Projection projection : kProjections) {
    CAPTURE(std::string(nameOf(projection)));
    CameraSettings s = settings(projection, widest(projection), 900, 900);
    s.elevation = 0.6;
    const Camera camera(s);
    const Vec3 axis = skyDirection(0.0, 0.6);
    int seen = 0;
    for (int i = 0; i < 3000; ++i) {
      // a third each: anywhere, around the axis at 1e-1 to 1e-12 rad, around its antipode
      const Vec3 noise{normal(random), normal(random), normal(random)};
      const double spread = std::pow(10.0, -1.0 - i % 12);
      const Vec3 v = i % 3 == 0 ? noise : (i % 3 == 1 ? axis : -axis) + spread * noise;
      const Vec3 direction = glm::normalize(v);
      const auto place = camera.project(direction);
      if (!place) continue;
      ++seen;
      const auto back = camera.toSky(*place);
      REQUIRE(back.has_value());
      // The picture is shrunk by 1e-12: at the rim of the orthographic picture that is 1e-12 / cos, at the antipode of
      // the equal-area one up to sqrt(8e-12) rad.
      const double cosine = glm::dot(direction, axis);
      double allowed = cosine > -0.9 ? 1e-11 : 3e-6;
      if (projection == Projection::fisheyeOrthographic) allowed = 3e-12 / std::max(cosine, 1e-6);
      CHECK(angleBetween(*back, direction) < allowed);
    }
    CHECK(seen > 1000);
  }
}

TEST_CASE("facing the sun, azimuth +90 is at the right and higher elevation is up, in every projection") {
  for (const Projection projection : kProjections) {
    CAPTURE(std::string(nameOf(projection)));
    const Camera camera(settings(projection, 100.0, 300, 200));
    const Vec2 centre = at(camera, 0.0, 0.0);
    CHECK(centre.x == doctest::Approx(150.0));
    CHECK(centre.y == doctest::Approx(100.0));
    CHECK(at(camera, 10.0, 0.0).x > 151.0);
    CHECK(at(camera, -10.0, 0.0).x < 149.0);
    CHECK(at(camera, 0.0, 10.0).y < 99.0);
    CHECK(at(camera, 0.0, -10.0).y > 101.0);
  }
}

TEST_CASE("looking at the zenith the sun is at the bottom and the observer's right at the right") {
  CameraSettings s = settings(Projection::fisheyeEqualArea, 180.0, 200, 200);
  s.elevation = 0.5 * kPi;
  const Camera camera(s);
  const Vec2 sun = at(camera, 0.0, 20.0), right = at(camera, 90.0, 20.0);
  CHECK(sun.x == doctest::Approx(100.0));
  CHECK(sun.y > 150.0);
  CHECK(right.x > 150.0);
  CHECK(right.y == doctest::Approx(100.0));
  // The limit of tilting up from the horizon: 89.999999 degrees give the same picture.
  s.elevation = radians(89.999999);
  CHECK(glm::length(at(Camera(s), 90.0, 20.0) - right) < 1e-4);
}

TEST_CASE("a camera rolled clockwise shows its content turned counter-clockwise") {
  CameraSettings s = settings(Projection::rectilinear, 90.0, 200, 200);
  s.roll = radians(90.0);
  const Camera camera(s);
  const Vec2 above = at(camera, 0.0, 20.0);
  CHECK(above.x < 80.0);  // what was up is now at the left
  CHECK(above.y == doctest::Approx(100.0));
}

TEST_CASE("the border of the picture lies at half the field of view along the axis asked for") {
  for (const Projection projection : kProjections) {
    CAPTURE(std::string(nameOf(projection)));
    CameraSettings s = settings(projection, 80.0, 300, 200);
    CHECK(at(Camera(s), 40.0 - 1e-9, 0.0).x == doctest::Approx(300.0).epsilon(1e-9));
    s.fieldOfViewAxis = FieldOfViewAxis::vertical;
    CHECK(at(Camera(s), 0.0, 40.0 - 1e-9).y == doctest::Approx(0.0).epsilon(1e-6));
    s.fieldOfViewAxis = FieldOfViewAxis::diagonal;
    const auto corner = Camera(s).toSky({300.0, 0.0});
    REQUIRE(corner.has_value());
    if (projection != Projection::equirectangular) {
      CHECK(angleBetween(*corner, {1.0, 0.0, 0.0}) == doctest::Approx(radians(40.0)).epsilon(1e-12));
    }
  }
}

TEST_CASE("at the poles, the axis and the antipode nothing is lost and nothing is NaN") {
  for (const Projection projection : kProjections) {
    CAPTURE(std::string(nameOf(projection)));
    for (const double elevation : {0.0, 0.5 * kPi, -0.5 * kPi}) {
      CameraSettings s = settings(projection, widest(projection), 512, 512);
      s.elevation = elevation;
      const Camera camera(s);
      const Vec3 axis = skyDirection(0.0, elevation);
      CHECK(camera.pixelAt(axis).has_value());
      const bool wholeSphere = projection == Projection::fisheyeEqualArea ||
                               projection == Projection::fisheyeEquidistant ||
                               projection == Projection::equirectangular;
      for (const Vec3& v : {-axis, Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{1, 0, 0}, Vec3{-1, 0, 0}, Vec3{0, 1, 0},
                            Vec3{-1, 0, 1e-17}, Vec3{-1, 1e-160, -1e-170}}) {
        const auto p = camera.project(v);
        if (wholeSphere) CHECK(p.has_value());
        if (p) CHECK((std::isfinite(p->x) && std::isfinite(p->y)));
      }
    }
  }
}

TEST_CASE("light exactly at the horizon is inside the image circle of an all-sky camera") {
  for (const Projection projection : {Projection::fisheyeEqualArea, Projection::fisheyeEquidistant,
                                      Projection::fisheyeStereographic, Projection::fisheyeOrthographic}) {
    CameraSettings s = settings(projection, 180.0, 512, 512);
    s.elevation = 0.5 * kPi;
    const Camera camera(s);
    const std::vector<double> omega = camera.solidAngles();
    for (int degree = 0; degree < 360; ++degree) {
      const auto pixel = camera.pixelAt(skyDirection(radians(degree), 0.0));
      REQUIRE(pixel.has_value());
      CHECK(omega[static_cast<std::size_t>(*pixel)] > 0.0);
    }
    CHECK_FALSE(camera.pixelAt(skyDirection(0.3, -1e-6)).has_value());
  }
}

TEST_CASE("an image circle of the scene's choice is the limit of what a fisheye shows") {
  CameraSettings s = settings(Projection::fisheyeEquidistant, 120.0, 400, 400);
  s.imageCircle = radians(100.0);
  const Camera camera(s);
  CHECK(camera.project(skyDirection(radians(49.9), 0.0)).has_value());
  CHECK_FALSE(camera.project(skyDirection(radians(50.1), 0.0)).has_value());
  CHECK_FALSE(camera.toSky({399.0, 200.0}).has_value());
  s.imageCircle = 0.0;  // fills its frame: the corners are within 90 degrees
  CHECK(Camera(s).toSky({0.0, 0.0}).has_value());
}

TEST_CASE("settings out of range are refused") {
  const auto refused = [](auto change) {
    CameraSettings s;
    change(s);
    CHECK_THROWS_AS(Camera{s}, std::invalid_argument);
  };
  refused([](CameraSettings& s) { s.width = 0; });
  refused([](CameraSettings& s) { s.height = kMaxImageSide + 1; });
  refused([](CameraSettings& s) { s.width = s.height = kMaxImageSide; });
  refused([](CameraSettings& s) { s.fieldOfView = 0.0; });
  refused([](CameraSettings& s) { s.fieldOfView = std::nan(""); });
  refused([](CameraSettings& s) { s.azimuth = std::nan(""); });
  refused([](CameraSettings& s) { s.elevation = 1.6; });
  refused([](CameraSettings& s) { s.imageCircle = -0.1; });
  refused([](CameraSettings& s) { s.projection = Projection::rectilinear; });  // 180 degrees
  refused([](CameraSettings& s) { s.projection = Projection::equirectangular, s.imageCircle = 1.0; });
  refused([](CameraSettings& s) { s.projection = Projection::fisheyeStereographic, s.fieldOfView = 2.0 * kPi; });
  refused([](CameraSettings& s) { s.projection = Projection::fisheyeOrthographic, s.fieldOfView = 3.2; });
}

}  // namespace parhelion
