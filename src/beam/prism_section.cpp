// SPDX-License-Identifier: Apache-2.0
#include "beam/prism_section.h"

#include <cmath>
#include <numeric>
#include <stdexcept>

#include <glm/geometric.hpp>

namespace parhelion {

namespace {

const double kHalfWidth = 0.5 * std::sqrt(3.0);  // of the regular hexagon of side 1

/// Sides are lengths of order 1; what rounding leaves of one that has no length.
constexpr double kNoSide = 1e-12;

}  // namespace

PrismSection::PrismSection(const std::array<double, 6>& distances) : distance(distances) {
  const double half = 0.5, wide = kHalfWidth;
  normal = {{{1.0, 0.0}, {half, wide}, {-half, wide}, {-1.0, 0.0}, {-half, -wide}, {half, -wide}}};
  for (std::size_t k = 0; k < 6; ++k) tangent[k] = {-normal[k].y, normal[k].x};
  // Two neighbours' lines meet where both distances are kept: on the line of face k, at (d' - d / 2) / sin 60 degrees
  // before its foot.
  for (std::size_t k = 0; k < 6; ++k) {
    const double before = distance[(k + 5) % 6];
    corner[k] = distance[k] * normal[k] - ((before - half * distance[k]) / wide) * tangent[k];
  }
  area = 0.0;
  for (std::size_t k = 0; k < 6; ++k) {
    side[k] = glm::dot(corner[(k + 1) % 6] - corner[k], tangent[k]);
    if (!(side[k] > -kNoSide)) throw std::invalid_argument("a prism's face lies outside the others");
    area += 0.5 * distance[k] * side[k];
  }
  if (!(area > 0.0)) throw std::invalid_argument("the faces of a prism enclose nothing");
}

PrismSection::PrismSection() : PrismSection({kHalfWidth, kHalfWidth, kHalfWidth, kHalfWidth, kHalfWidth, kHalfWidth}) {}

double PrismSection::surface(double length) const {
  return std::accumulate(side.begin(), side.end(), 0.0) * length + 2.0 * area;
}

}  // namespace parhelion
