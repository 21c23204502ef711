// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "math/conventions.h"

namespace parhelion {

/// The cross-section of a hexagonal prism: six lines whose normals are 60 degrees apart, that of face 3 along the
/// crystal's +x. Sides may differ in length, and up to three of them may have none.
struct PrismSection {
  /// `distances` of faces 3 ... 8 from the axis, in units of the hexagon's side. Throws std::invalid_argument where
  /// they leave no hexagon, or a face lies outside all others.
  explicit PrismSection(const std::array<double, 6>& distances);

  /// The regular hexagon of side 1.
  PrismSection();

  /// Of a prism so long, both ends included.
  double surface(double length) const;

  std::array<double, 6> distance;
  std::array<Vec2, 6> normal, tangent;  // outwards, and counter-clockwise along the face
  std::array<Vec2, 6> corner;           // number k lies between face k - 1 and face k, faces counted from 0
  std::array<double, 6> side;           // lengths
  double area;
};

}  // namespace parhelion
