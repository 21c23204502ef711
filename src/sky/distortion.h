// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/inline.h"

namespace parhelion {

/// What a real lens adds to its projection (Brown 1966, the radial part): a place at distance r from the picture's
/// centre, in focal lengths of the ideal lens, moves to r (1 + k1 r^2 + k2 r^4 + k3 r^6).
struct Distortion {
  double k1 = 0.0, k2 = 0.0, k3 = 0.0;

  bool operator==(const Distortion&) const = default;

  bool none() const { return k1 == 0.0 && k2 == 0.0 && k3 == 0.0; }

  /// Where a radius moves to, over that radius, of its square.
  template <class T>
  PARHELION_INLINE T factor(const T& squared) const {
    return 1.0 + squared * (k1 + squared * (k2 + squared * k3));
  }

  double distorted(double radius) const { return radius * factor(radius * radius); }

  /// The radius at which the picture folds over and beyond which the formula means nothing; infinite if it never does.
  double foldRadius() const;

  /// The radius in [0, `limit`] that moves to `radius`, to rounding. It must be one of those reached up to `limit`,
  /// which must not lie beyond the fold and may be infinite.
  double undistorted(double radius, double limit) const;
};

}  // namespace parhelion
