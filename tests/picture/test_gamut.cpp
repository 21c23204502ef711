// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "picture/colour_space.h"
#include "picture/gamut.h"

namespace parhelion {

TEST_CASE("a colour outside the gamut moves straight toward grey until its lowest component is 0") {
  for (const Vec3& colour :
       {Vec3(1.0, 0.2, -0.3), Vec3(-0.5, 0.8, 0.1), Vec3(-0.01, -0.02, 0.9), Vec3(2e-9, 1e-9, -1e-9)}) {
    const Vec3 clipped = intoGamut(colour);
    const double luminance = glm::dot(kRec709Luminance, colour);
    const double lowest = std::min({clipped.x, clipped.y, clipped.z});
    CHECK(lowest >= 0.0);
    CHECK(lowest <= 1e-15 * luminance);
    CHECK(glm::dot(kRec709Luminance, clipped) == doctest::Approx(luminance).epsilon(1e-14));
    // On one straight line with the grey: the same hue, less of it.
    const Vec3 before = colour - Vec3(luminance), after = clipped - Vec3(luminance);
    CHECK(glm::length(glm::cross(before, after)) <= 1e-14 * glm::dot(before, before));
    CHECK(glm::dot(before, after) > 0.0);
    CHECK(glm::length(after) < glm::length(before));
    CHECK(intoGamut(7.0 * colour).x == doctest::Approx(7.0 * clipped.x).epsilon(1e-12));
  }
}

TEST_CASE("colours in the gamut keep their bits, those without light are black, and what is no number stays") {
  for (const Vec3& colour : {Vec3(0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.3, 1e30, 1e-30)})
    CHECK(intoGamut(colour) == colour);
  CHECK(intoGamut({-0.1, -0.2, -0.3}) == Vec3(0.0));
  CHECK(intoGamut({-1.0, 0.1, 1.0}) == Vec3(0.0));
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  CHECK(intoGamut({kInfinity, -1.0, 0.0}) == Vec3(kInfinity, -1.0, 0.0));
  CHECK(std::isnan(intoGamut({std::nan(""), -1.0, 0.0}).x));
}

}  // namespace parhelion
