// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "pointing_cameras.h"

namespace parhelion {
namespace {

// rad. Directions this far apart leave no freedom that would make rounding larger.
constexpr double kApart = radians(8.0);

}  // namespace

TEST_CASE("two directions give back the camera of every lens and orientation") {
  Draw draw(1);
  for (const LensKind& kind : kLenses) {
    for (int trial = 0; trial < 60; ++trial) {
      CameraSettings truth = draw.turned(lensOf(kind));
      if (trial < 10) truth.elevation = trial % 2 == 0 ? 0.5 * kPi : -0.5 * kPi;
      const Camera camera(truth);
      const Vec3 a = draw.seen(camera, kind.reach), b = draw.seen(camera, kind.reach);
      const double apart = angleBetween(a, b);
      if (apart < kApart || apart > kPi - kApart) continue;
      const std::vector clues = {clueOf(camera, a, Tells::direction), clueOf(camera, b, Tells::direction)};
      const Pointing found = findPointing(lensOf(kind), clues);
      CAPTURE(std::string(nameOf(kind.projection)));
      CAPTURE(trial);
      CHECK(largestDifference(truth, turnedAs(truth, found)) < kExact);
      CHECK(found.rmsAngle() < kExact);
      CHECK(found.rmsPixels() < 1e-6);
      const Camera again(turnedAs(truth, found));
      for (std::size_t k = 0; k < clues.size(); ++k)
        CHECK(glm::distance(*again.placeOf(k == 0 ? a : b), clues[k].pixel) < 1e-6);
    }
  }
}

TEST_CASE("one direction and the roll give back the camera or one nearer to the horizon") {
  Draw draw(2);
  int trials = 0, recovered = 0;
  for (const LensKind& kind : kLenses) {
    for (int trial = 0; trial < 60; ++trial) {
      CameraSettings truth = draw.turned(lensOf(kind));
      if (trial < 10) truth.elevation = trial % 2 == 0 ? 0.5 * kPi : -0.5 * kPi;
      const Camera camera(truth);
      const Vec3 sun = draw.seen(camera, kind.reach);
      // Where raising the camera moves the sun sideways, and at the zenith, its place says too little.
      const Vec3 right = skyDirection(truth.azimuth + 0.5 * kPi, 0.0);
      if (std::abs(glm::cross(right, sun).z) < 0.1 || sun.z * sun.z > 0.98) continue;
      const PointingClue clue = clueOf(camera, sun, Tells::direction);
      const Pointing found = findPointing(lensOf(kind), std::vector{clue}, truth.roll);
      CAPTURE(std::string(nameOf(kind.projection)));
      CAPTURE(trial);
      CHECK(found.roll == truth.roll);
      CHECK(found.rmsAngle() < kExact);
      CHECK(glm::distance(Camera(turnedAs(truth, found)).placeOf(sun).value(), clue.pixel) < 1e-6);
      const bool same = largestDifference(truth, turnedAs(truth, found)) < kExact;
      CHECK((same || std::abs(found.elevation) < std::abs(truth.elevation) + kExact));
      ++trials;
      recovered += same ? 1 : 0;
    }
  }
  CHECK(trials > 200);
  CHECK(recovered > trials / 2);
}

TEST_CASE("a camera near the horizon is given back by the sun and its roll") {
  Draw draw(3);
  for (int trial = 0; trial < 100; ++trial) {
    const CameraSettings truth = draw.turned(landscape(), 1.0, 0.3, 0.2);
    const Vec3 sun = skyDirection(0.0, draw.from(0.0, 0.5));
    const Pointing found =
        findPointing(landscape(), std::vector{clueOf(Camera(truth), sun, Tells::direction)}, truth.roll);
    CHECK(largestDifference(truth, turnedAs(truth, found)) < kExact);
  }
}

TEST_CASE("two elevations and an azimuth give back the upright camera") {
  Draw draw(4);
  int trials = 0;
  for (const LensKind& kind : kLenses) {
    for (int trial = 0; trial < 200; ++trial) {
      CameraSettings truth = draw.turned(lensOf(kind));
      if (trial % 10 == 0) truth.elevation = 0.5 * kPi;
      truth.roll = draw.from(-0.3, 0.3);
      if (truth.elevation < -1.2) continue;
      const Camera camera(truth);
      const Vec3 a = draw.seen(camera, kind.reach), b = draw.seen(camera, kind.reach);
      const Vec3 sun = draw.seen(camera, kind.reach);
      // The zenith must lie well off the plane of the two, and the sun well off the zenith.
      const Vec3 normal = glm::cross(a, b);
      if (glm::length(normal) < 0.3 || std::abs(normal.z) < 0.1 || sun.z * sun.z > 0.97) continue;
      const std::vector clues = {clueOf(camera, a, Tells::elevation), clueOf(camera, b, Tells::elevation),
                                 clueOf(camera, sun, Tells::azimuth)};
      const Pointing found = findPointing(lensOf(kind), clues);
      CAPTURE(std::string(nameOf(kind.projection)));
      CAPTURE(trial);
      CHECK(found.rmsAngle() < kExact);
      const bool same = largestDifference(truth, turnedAs(truth, found)) < kExact;
      const auto upright = [](double elevation, double roll) {
        return std::cos(elevation) * std::cos(roll) + 0.1 * std::sin(elevation);
      };
      CHECK((same || upright(found.elevation, found.roll) > upright(truth.elevation, truth.roll)));
      if (same) ++trials;
    }
  }
  CHECK(trials > 200);
}

TEST_CASE("a direction and the azimuth of another give a camera that sees both where they are") {
  Draw draw(9);
  int recovered = 0;
  for (int trial = 0; trial < 100; ++trial) {
    const LensKind& kind = kLenses[static_cast<std::size_t>(trial) % kLenses.size()];
    const CameraSettings truth = draw.turned(lensOf(kind));
    const Camera camera(truth);
    const Vec3 sun = camera.directionAt({600.0, 400.0}).value(), other = camera.directionAt({1200.0, 700.0}).value();
    const std::vector clues = {clueOf(camera, sun, Tells::direction), clueOf(camera, other, Tells::azimuth)};
    const CameraSettings found = turnedAs(truth, findPointing(lensOf(kind), clues));
    CAPTURE(trial);
    // An upright camera may be preferred that is off by up to a pixel.
    const double pixelAngle = 1.5 / camera.focalLength();
    CHECK(angleBetween(Camera(found).directionAt(clues[0].pixel).value(), sun) < pixelAngle);
    const SkyPoint point = skyPoint(Camera(found).directionAt(clues[1].pixel).value());
    const double off = std::remainder(point.azimuth - *clues[1].azimuth, 2.0 * kPi);
    CHECK(std::cos(point.elevation) * std::abs(off) < pixelAngle);
    recovered += largestDifference(truth, found) < kExact ? 1 : 0;
  }
  CHECK(recovered > 40);
}

TEST_CASE("two points of the horizon and the sun give back the camera with and without the sun's elevation") {
  Draw draw(5);
  for (int trial = 0; trial < 100; ++trial) {
    const CameraSettings truth = draw.turned(landscape(), 0.9, 0.3, 0.4);
    const Camera camera(truth);
    const Vec3 sun = skyDirection(0.0, draw.from(0.0, 0.8));
    const Vec3 left = skyDirection(truth.azimuth - 0.4, 0.0), right = skyDirection(truth.azimuth + 0.3, 0.0);
    for (const Tells tells : {Tells::direction, Tells::azimuth}) {
      const std::vector clues = {clueOf(camera, sun, tells), clueOf(camera, left, Tells::elevation),
                                 clueOf(camera, right, Tells::elevation)};
      CHECK(largestDifference(truth, turnedAs(truth, findPointing(landscape(), clues))) < kExact);
    }
  }
}

TEST_CASE("a camera at the zenith is given back by the horizon around it and the sun") {
  CameraSettings truth = lensOf({Projection::fisheyeEqualArea, radians(120.0), 0.0});
  for (const double azimuth : {0.0, 0.4, -2.0}) {
    truth.azimuth = azimuth;
    truth.elevation = 0.5 * kPi;
    truth.roll = 1.1;
    const Camera camera(truth);
    const std::vector clues = {clueOf(camera, skyDirection(0.3, 0.0), Tells::elevation),
                               clueOf(camera, skyDirection(1.9, 0.0), Tells::elevation),
                               clueOf(camera, skyDirection(0.0, 0.2), Tells::azimuth)};
    CHECK(largestDifference(truth, turnedAs(truth, findPointing(truth, clues))) < kExact);
  }
}

TEST_CASE("mixtures of clues that are more than enough give back the camera") {
  Draw draw(6);
  constexpr std::array kMixtures = {std::array{Tells::direction, Tells::elevation, Tells::azimuth, Tells::elevation},
                                    std::array{Tells::direction, Tells::azimuth, Tells::azimuth, Tells::azimuth},
                                    std::array{Tells::elevation, Tells::azimuth, Tells::azimuth, Tells::azimuth},
                                    std::array{Tells::elevation, Tells::elevation, Tells::elevation, Tells::azimuth},
                                    std::array{Tells::direction, Tells::direction, Tells::elevation, Tells::azimuth}};
  for (const LensKind& kind : kLenses) {
    for (const auto& mixture : kMixtures) {
      for (int trial = 0; trial < 4; ++trial) {
        CameraSettings truth = draw.turned(lensOf(kind));
        truth.elevation = draw.from(-0.5, 0.7);
        truth.roll = draw.from(-0.3, 0.3);
        const Camera camera(truth);
        std::vector<PointingClue> clues;
        for (const Vec2& place : {Vec2(300, 350), Vec2(1200, 250), Vec2(1100, 800), Vec2(200, 900)})
          clues.push_back(clueOf(camera, camera.directionAt(place).value(), mixture[clues.size()]));
        CAPTURE(std::string(nameOf(kind.projection)));
        CAPTURE(&mixture - kMixtures.data());
        CHECK(largestDifference(truth, turnedAs(truth, findPointing(lensOf(kind), clues))) < kExact);
        CHECK(largestDifference(truth, turnedAs(truth, findPointing(lensOf(kind), clues, truth.roll))) < kExact);
      }
    }
  }
}

}  // namespace parhelion
