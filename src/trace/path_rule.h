// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

#include "math/lanes.h"
#include "trace/trace_settings.h"

namespace parhelion {

/// How a path goes on at a face.
struct PathRule {
  /// A path splits while it carries at least this share of its ray's light; below, it goes one way as a whole, picked
  /// by chance. The mean does not depend on it.
  double splitShare;
};

/// Half of the light: chosen by variance times time.
inline PathRule pathRule(PathMode mode) {
  return {mode == PathMode::chance ? std::numeric_limits<double>::infinity() : 0.5};
}

// Thin plates and long columns hold light by total reflection for some thousand encounters. What is still inside after
// this many counts as cut off.
inline constexpr int kMostEncounters = 1'000'000;

// Two directions closer than this (rad) are one: rounding leaves 1e-15 per encounter, and light deviated by less than
// this is none of any halo's.
inline constexpr double kSameDirection = 1e-8;

/// Whether two unit vectors are one direction: of a single ray, or of the lanes of T. Vector is Vec3, or Triple<T>.
template <class T, class Vector>
PARHELION_INLINE MaskOf<T> isSameDirection(const Vector& a, const Vector& b) {
  const Vector change = a - b;
  return dot(change, change) < kSameDirection * kSameDirection;
}

}  // namespace parhelion
