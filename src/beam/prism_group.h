// SPDX-License-Identifier: Apache-2.0
#pragma once

// What reflections inside a prism do to a direction. Those in its side faces, whose normals are 60 degrees apart, make
// six rotations and mirror images of the plane across c, whatever the lengths of the sides. Those in its two ends turn
// the direction along c around. So all chains of reflections come to twelve.

#include "math/inline.h"

namespace parhelion {

/// Elements of the plane: turn m (0 ... 2) takes the angle phi of a direction to phi + 120 m degrees, 3 + m takes it to
/// 180 + 120 m - phi degrees.
inline constexpr int kPlaneElements = 6;

/// An element of the plane, and how often ends have reflected, odd or even: plane + 6 * odd.
inline constexpr int kPrismElements = 12;

/// The element after a reflection in side face `side` (0 ... 5), whose normal is at 60 * side degrees.
constexpr int afterReflection(int plane, int side) {
  const int turn = ((side - plane % 3) % 3 + 3) % 3;
  return plane < 3 ? 3 + turn : turn;
}

/// Cosine and sine of 120 m degrees.
inline constexpr double kThirdCos[3] = {1.0, -0.5, -0.5};
inline constexpr double kThirdSin[3] = {0.0, 0.86602540378443864676, -0.86602540378443864676};

/// What an element does to a vector of the plane: Vec2, or one whose coordinates are lanes.
template <class Vector>
PARHELION_INLINE Vector inPlane(int plane, const Vector& v) {
  const double c = kThirdCos[plane % 3], s = kThirdSin[plane % 3];
  if (plane < 3) return {c * v.x - s * v.y, s * v.x + c * v.y};
  return {-(c * v.x + s * v.y), c * v.y - s * v.x};
}

}  // namespace parhelion
