// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "recon/synthetic_tally.h"

namespace parhelion {
namespace {

constexpr int kSide = 128;
constexpr double kHits = 40.0;  // a mean pixel

/// A tilted camera whose horizon goes slantwise through the picture.
TallyInfo tilted(Projection projection) {
  TallyInfo info = fullSky(kSide);
  info.camera.projection = projection;
  info.camera.fieldOfView = radians(100.0);
  info.camera.elevation = radians(8.0);
  info.camera.roll = radians(17.0);
  info.camera.horizon = Horizon::cut;
  return info;
}

}  // namespace

TEST_CASE("an even sky is even down to a horizon that is cut, and nothing is below it") {
  for (const Projection projection : {Projection::rectilinear, Projection::fisheyeEquidistant}) {
    const TallyInfo info = tilted(projection);
    const Camera camera(info.camera);
    const std::vector<double> solidAngles = camera.solidAngles();
    const double mean = 1.0 / (camera.focalLength() * camera.focalLength());  // sr, of a pixel on the axis
    const Tally tally = poissonTally(
        info, [&](int x, int y) { return kHits * solidAngles[static_cast<std::size_t>(y) * kSide + x] / mean; }, 11);
    const Image image = adaptive(tally);
    const std::vector<float>& radiance = *image.find("G");
    const double even = kHits / (mean * 1e6);
    double nearest = 0.0, count = 0.0, light = 0.0;
    for (int y = 0; y < kSide; ++y) {
      for (int x = 0; x < kSide; ++x) {
        const std::size_t i = static_cast<std::size_t>(y) * kSide + x;
        const double value = static_cast<double>(radiance[i]);
        light += value * solidAngles[i] * 1e6;
        if (solidAngles[i] == 0.0) {
          CHECK(value == 0.0);
          continue;
        }
        // Slivers of a pixel hold less than a hit.
        if (solidAngles[i] > 0.1 * mean) CHECK(value < 1.6 * even);
        // The first two rows of pixels above the horizon.
        const auto toSky = camera.toSky({x + 0.5, y + 0.5});
        if (toSky && toSky->z > 2.0 / camera.focalLength()) continue;
        nearest += value * solidAngles[i];
        count += solidAngles[i];
      }
    }
    // 250 pixels of 40 hits: 1 % before any filter.
    CHECK(nearest / count == doctest::Approx(even).epsilon(0.04));
    CHECK(light == doctest::Approx(lightIn(tally)).epsilon(1e-4));
  }
}

}  // namespace parhelion
