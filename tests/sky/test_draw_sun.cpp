// SPDX-License-Identifier: Apache-2.0
// The sun's disc in pictures of few and of many pixels: how much light, and for how much work.
#include <doctest/doctest.h>

#include <algorithm>
#include <ctime>
#include <limits>

#include "math/rotation.h"
#include "sky/draw_sun.h"
#include "sky/look_at.h"

namespace parhelion {
namespace {

SunSettings lowSun() {
  SunSettings settings;
  settings.elevation = radians(20.0);
  settings.diameter = radians(0.533);
  return settings;
}

/// Its pixels have the same solid angle everywhere, so the light does not depend on where in a pixel the sun is.
CameraSettings towardSun(int width, int height, double fovDegrees) {
  return test::lookAt(Projection::fisheyeEqualArea, 0.7, 20.4, 0.0, fovDegrees, width, height);
}

Image black(int width, int height) {
  Image image{width, height, {}};
  for (const char* name : {"R", "G", "B"}) image.add(name);
  return image;
}

/// Processor seconds of this thread for work(), the least of some tries.
template <class Work>
double cost(const Work& work) {
  const auto now = [] {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  double least = std::numeric_limits<double>::max();
  for (int i = 0; i < 5; ++i) {
    const double start = now();
    work();
    least = std::min(least, now() - start);
  }
  return least;
}

}  // namespace

TEST_CASE("the drawn sun has its light to a thousandth, in pixels larger and smaller than its disc") {
  const Sun sun(lowSun());
  for (const auto& [width, height, fov] : {std::tuple{20, 17, 90.0}, {160, 120, 60.0}, {200, 150, 4.0}}) {
    CAPTURE(width);
    const Camera camera(towardSun(width, height, fov));
    Image image = black(width, height);
    drawUndeviatedSun(image, camera, sun, 0.25);
    double light = 0.0;
    for (int pixel = 0; pixel < width * height; ++pixel)
      light +=
          image.channels[1].samples[static_cast<std::size_t>(pixel)] * camera.solidAngle(pixel % width, pixel / width);
    CHECK(light == doctest::Approx(0.25).epsilon(1e-3));
  }
}

TEST_CASE("a sun far smaller than a pixel costs no more than a few ten thousand looks through the camera") {
  const Sun sun(lowSun());
  const Camera camera(towardSun(20, 17, 90.0));
  constexpr int kLooks = 10'000;
  double sink = 0.0;
  const double look = cost([&] {
                        for (int i = 0; i < kLooks; ++i) {
                          const auto toSky = camera.toSky(Vec2(1e-3 * i, 8.5));
                          if (toSky) sink += angleBetween(*toSky, sun.toCentre());
                        }
                      }) /
                      kLooks;
  Image image = black(20, 17);
  const double drawing = cost([&] { drawUndeviatedSun(image, camera, sun, 0.25); });
  MESSAGE("drawing the sun costs as much as " << drawing / look << " looks");
  CHECK(sink > 0.0);
  // One look for each of the samples of a single pixel would be a quarter of a million.
  CHECK(drawing < 100'000 * look);
}

}  // namespace parhelion
