// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

#include "sky/camera.h"

namespace parhelion::test {

/// Checks that a million rays from all over the sky fall into each pixel by its solid angle: chi squared within 5
/// sigma. `look(toSky, pixel)` is called with each of them.
template <class Look>
void checkIsotropicLight(const Camera& camera, const Look& look) {
  constexpr int kRays = 1'000'000;
  std::vector<int> hits(static_cast<std::size_t>(camera.width()) * camera.height());
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  for (int i = 0; i < kRays; ++i) {
    const Vec3 toSky = glm::normalize(Vec3(normal(random), normal(random), normal(random)));
    const std::optional<int> pixel = camera.pixelAt(toSky);
    if (pixel) ++hits[static_cast<std::size_t>(*pixel)];
    look(toSky, pixel);
  }
  const std::vector<double> solidAngles = camera.solidAngles();
  double squares = 0.0;
  int pixels = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const double expected = kRays * solidAngles[i] / (4.0 * kPi);
    if (expected < 5.0) {
      CHECK(hits[i] <= 25);
      continue;
    }
    squares += (hits[i] - expected) * (hits[i] - expected) / expected;
    ++pixels;
  }
  // Chi squared of so many pixels, 5 sigma.
  CHECK(std::abs(squares - pixels) < 5.0 * std::sqrt(2.0 * pixels));
}

}  // namespace parhelion::test
