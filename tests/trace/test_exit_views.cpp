// SPDX-License-Identifier: Apache-2.0
// Where exits and their mirror images are seen, many at a time, is where the camera says of each alone.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "../sky/look_at.h"
#include "math/rotation.h"
#include "sky/camera.h"
#include "sky/sky_view.h"
#include "trace/lane_steps.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

Vec3 mirrorImage(const Vec3& v) { return {v.x, -v.y, v.z}; }

/// Directions all over the sky and some where rounding decides: the poles, the sun's vertical plane, the borders of
/// pixels and their mirror images.
std::vector<Vec3> directions(const Camera& camera, int count) {
  std::mt19937_64 random(7);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::vector<Vec3> all{{0, 0, 1}, {0, 0, -1}, {-0.0, 0.0, 1}, {1, 0, 0}, {-1, 0, 0}, {-1, -0.0, 0}, {0.6, 0, 0.8}};
  for (int i = 0; i < count; ++i)
    all.push_back(skyDirection(2.0 * kPi * uniform(), std::asin(std::clamp(2.0 * uniform() - 1.0, -1.0, 1.0))));
  for (int i = 0; i < count / 10; ++i) {
    const Vec2 corner{std::floor(uniform() * (camera.width() + 1)), std::floor(uniform() * (camera.height() + 1))};
    const Vec2 inside{uniform() * camera.width(), uniform() * camera.height()};
    for (const Vec2& place : {corner, Vec2(corner.x, inside.y), Vec2(inside.x, corner.y)})
      if (const auto toSky = camera.directionAt(place)) {
        all.push_back(*toSky);
        all.push_back(mirrorImage(*toSky));
      }
  }
  return all;
}

ExitList exitsToward(const std::vector<Vec3>& toSky) {
  ExitList exits;
  exits.reserve(static_cast<int>(toSky.size()) + RayQueue::kSpare);
  for (const Vec3& v : toSky) {
    const int i = exits.count++;
    for (int k = 0; k < 3; ++k) exits.lightDirWorld[k][i] = -v[k];
    exits.ray[i] = 3.0 * i;
    exits.undeviated[i] = i % 50 == 49;
  }
  return exits;
}

SeenLight seenBy(const LaneSteps& steps, const Camera& camera, bool bothViews, const ExitList& exits) {
  SeenLight seen;
  const auto room = static_cast<std::size_t>(exits.count + RayQueue::kSpare);
  for (auto* row : {&seen.exit, &seen.ray, &seen.pixel, &seen.mirroredPixel}) row->resize(room, 1e300);
  steps.see(SkyView(camera), bothViews, exits, seen);
  return seen;
}

void checkViews(const LaneSteps& steps, const Camera& camera, bool bothViews, int count) {
  const std::vector<Vec3> toSky = directions(camera, count);
  const ExitList exits = exitsToward(toSky);
  const SeenLight seen = seenBy(steps, camera, bothViews, exits);
  int at = 0, wrong = 0;
  for (int i = 0; i < exits.count; ++i) {
    const auto pixelOf = [&](const Vec3& v) {
      return camera.pixelAt(v).value_or(static_cast<int>(SeenLight::kNowhere));
    };
    const int own = pixelOf(toSky[i]), mirrored = bothViews ? pixelOf(mirrorImage(toSky[i])) : -1;
    if (exits.undeviated[i] != 0.0 || (own < 0 && mirrored < 0)) continue;
    REQUIRE(at < seen.count);
    wrong += seen.exit[at] != i || seen.ray[at] != exits.ray[i] || seen.pixel[at] != own ||
             (bothViews && seen.mirroredPixel[at] != mirrored);
    ++at;
  }
  CHECK(wrong == 0);
  CHECK(at == seen.count);
  CHECK(at > 0);
}

std::vector<CameraSettings> panoramas() {
  const auto panorama = [](double azimuth, double fieldOfView, int width, int height) {
    return lookAt(Projection::equirectangular, azimuth, 0.0, 0.0, fieldOfView, width, height);
  };
  std::vector<CameraSettings> all;
  for (const double azimuth : {30.0, 45.0, -123.4, 90.0, 180.0, 0.0, 1000.0})
    for (const int width : {64, 63, 2048, 1}) all.push_back(panorama(azimuth, 360.0, width, std::max(1, width / 2)));
  all.push_back(panorama(77.0, 200.0, 101, 53));
  all.push_back(panorama(-5.0, 1e-3, 1000, 500));
  all.push_back(panorama(150.0, 359.5, 1000, 700));
  all.push_back(lookAt(Projection::equirectangular, 30.0, 20.0, 0.0, 360.0, 300, 150));
  all.push_back(lookAt(Projection::equirectangular, 30.0, 0.0, 10.0, 360.0, 300, 150));
  all.push_back(panorama(20.0, 360.0, 128, 64));
  all.back().horizon = Horizon::cut;
  return all;
}

std::vector<CameraSettings> lenses() {
  std::vector<CameraSettings> all;
  for (const double fieldOfView : {2.0, 60.0, 170.0}) {
    all.push_back(lookAt(Projection::rectilinear, 30.0, 20.0, 7.0, fieldOfView, 101, 52));
    all.push_back(lookAt(Projection::rectilinear, -1.0, 0.1, 0.0, fieldOfView, 50, 99));
    all.back().horizon = Horizon::cut;
    all.push_back(lookAt(Projection::rectilinear, 20.0, 10.0, 0.0, fieldOfView, 64, 64));
    all.back().distortion = {0.02, 0.001, 0.0};
    all.back().shift = {0.1, -0.2};
  }
  all.push_back(lookAt(Projection::rectilinear, 20.0, 10.0, 0.0, 60.0, 64, 64));
  all.back().distortion = {-0.1, 0.0, 0.0};
  for (const Projection projection : {Projection::fisheyeEqualArea, Projection::fisheyeEquidistant,
                                      Projection::fisheyeStereographic, Projection::fisheyeOrthographic}) {
    all.push_back(lookAt(projection, 40.0, 30.0, 0.0, 180.0, 90, 91));
    all.push_back(lookAt(projection, 40.0, 30.0, 0.0, 50.0, 90, 60));
  }
  all.push_back(lookAt(Projection::dualFisheyeEqualArea, 25.0, 10.0, 5.0, 180.0, 100, 50));
  all.push_back(lookAt(Projection::globe, 25.0, 10.0, 5.0, 180.0, 80, 80));
  return all;
}

}  // namespace

TEST_CASE("exits and their mirror images are seen in the camera's pixels: panoramas of many headings and widths") {
  for (const Simd simd : simdHere())
    for (const CameraSettings& camera : panoramas()) {
      CAPTURE(camera.azimuth);
      CAPTURE(camera.width);
      checkViews(laneSteps(simd), Camera(camera), true, 20'000);
    }
}

TEST_CASE("exits and their mirror images are seen in the camera's pixels: lenses, shifted and distorted ones too") {
  for (const Simd simd : simdHere())
    for (const CameraSettings& camera : lenses())
      for (const bool bothViews : {false, true}) {
        CAPTURE(nameOf(camera.projection));
        CAPTURE(camera.fieldOfView);
        checkViews(laneSteps(simd), Camera(camera), bothViews, 20'000);
      }
}
