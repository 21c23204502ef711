// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

#include "math/rotation.h"
#include "sky/camera.h"

using namespace parhelion;

namespace {

/// Cameras whose distortions are as strong as real lenses have them, barrel and pincushion and both.
std::vector<CameraSettings> distortedCameras() {
  std::vector<CameraSettings> all;
  for (const Projection projection :
       {Projection::rectilinear, Projection::fisheyeEqualArea, Projection::fisheyeEquidistant,
        Projection::fisheyeStereographic, Projection::fisheyeOrthographic}) {
    for (const Distortion& d :
         {Distortion{-0.12, 0.02, 0.0}, Distortion{0.08, -0.01, 0.003}, Distortion{0.0, 0.0, 0.02}}) {
      CameraSettings camera;
      camera.projection = projection;
      camera.fieldOfView = radians(80.0);
      camera.azimuth = 0.4;
      camera.elevation = 0.6;
      camera.roll = -0.3;
      camera.width = 60;
      camera.height = 40;
      camera.distortion = d;
      all.push_back(camera);
    }
  }
  return all;
}

}  // namespace

TEST_CASE("a distorted place is where the formula of Brown puts it") {
  CameraSettings settings;
  settings.projection = Projection::rectilinear;
  settings.elevation = 0.0;
  settings.fieldOfView = radians(90.0);
  settings.width = settings.height = 200;  // a focal length of 100 pixels
  settings.distortion = {-0.1, 0.03, -0.002};
  const double theta = radians(35.0), r = std::tan(theta), r2 = r * r;
  const auto place = Camera(settings).project(skyDirection(theta, 0.0));
  REQUIRE(place);
  CHECK(place->x ==
        doctest::Approx(100.0 + 100.0 * r * (1.0 - 0.1 * r2 + 0.03 * r2 * r2 - 0.002 * r2 * r2 * r2)).epsilon(1e-12));
  CHECK(place->y == doctest::Approx(100.0).epsilon(1e-12));
}

TEST_CASE("places in a distorted picture lead to the sky and back") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (const CameraSettings& settings : distortedCameras()) {
    const Camera camera(settings);
    for (int i = 0; i < 500; ++i) {
      const Vec2 pixel{settings.width * uniform(random), settings.height * uniform(random)};
      const auto toSky = camera.toSky(pixel);
      REQUIRE(toSky);
      CHECK(std::abs(glm::length(*toSky) - 1.0) < 1e-14);
      const auto back = camera.project(*toSky);
      REQUIRE(back);
      CHECK(glm::distance(*back, pixel) < 1e-9);  // pixels; places are shrunk by 1e-12 of the picture
    }
  }
}

TEST_CASE("solid angles of distorted pixels are the areas of their outlines on the sky") {
  for (const CameraSettings& settings : distortedCameras()) {
    const Camera camera(settings);
    for (const auto& [x, y] : {std::pair{0, 0}, {29, 19}, {12, 33}, {59, 20}}) {
      // The outline's polygon by triangles about its middle; their planes cut corners, less with each split.
      const auto area = [&](int parts) {
        double sum = 0.0;
        const double step = 1.0 / parts;
        for (int j = 0; j < parts; ++j) {
          for (int i = 0; i < parts; ++i) {
            const Vec2 p{x + i * step, y + j * step};
            const Vec3 a = *camera.toSky(p), b = *camera.toSky(p + Vec2(step, 0.0));
            const Vec3 c = *camera.toSky(p + Vec2(step)), d = *camera.toSky(p + Vec2(0.0, step));
            sum += 0.5 * glm::length(glm::cross(c - a, d - b));
          }
        }
        return sum;
      };
      const double coarse = area(16), fine = area(32);
      const double extrapolated = fine + (fine - coarse) / 3.0;
      CHECK(std::abs(camera.solidAngle(x, y) / extrapolated - 1.0) < 1e-7);
    }
  }
}

TEST_CASE("a distorted fisheye's pixels add up to its image circle") {
  CameraSettings settings;
  settings.imageCircle = radians(170.0);
  settings.width = settings.height = 90;
  settings.distortion = {0.03, -0.004, 0.0};
  const std::vector<double> all = Camera(settings).solidAngles();
  const double cap = 2.0 * kPi * (1.0 - std::cos(0.5 * settings.imageCircle));
  CHECK(std::abs(std::accumulate(all.begin(), all.end(), 0.0) / cap - 1.0) < 1e-9);
}

TEST_CASE("a distortion that folds the picture over inside its corners is refused") {
  CameraSettings settings;
  settings.projection = Projection::rectilinear;
  settings.fieldOfView = radians(90.0);
  settings.distortion = {-0.2, 0.0, 0.0};  // folds at r = 1.29, where it shows 0.86; the corners are at 1.41
  CHECK_THROWS_WITH_AS(Camera{settings}, doctest::Contains("folds"), std::invalid_argument);
  settings.fieldOfView = radians(50.0);
  settings.elevation = 0.0;
  const Camera narrow(settings);
  // Beyond the fold, atan 1.29 = 52.2 degrees, the formula would bring the sky back into the picture.
  CHECK(narrow.placeOf(skyDirection(radians(52.0), 0.0)));
  CHECK_FALSE(narrow.placeOf(skyDirection(radians(53.0), 0.0)));
  CHECK_FALSE(narrow.project(skyDirection(radians(65.0), 0.0)));
}
