// SPDX-License-Identifier: Apache-2.0
#include "picture/gamut.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "picture/colour_space.h"

namespace parhelion {

Vec3 intoGamut(const Vec3& colour) {
  const double lowest = std::min({colour.x, colour.y, colour.z});
  const bool isFinite = std::isfinite(colour.x) && std::isfinite(colour.y) && std::isfinite(colour.z);
  if (!isFinite || lowest >= 0.0) return colour;
  const double luminance = glm::dot(kRec709Luminance, colour);
  if (luminance <= 0.0) return {0.0, 0.0, 0.0};
  const double keep = luminance / (luminance - lowest);
  return glm::max(Vec3(luminance) + keep * (colour - Vec3(luminance)), Vec3(0.0));
}

}  // namespace parhelion
