// SPDX-License-Identifier: Apache-2.0
#pragma once

// What several projections share.

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "math/arctangent.h"
#include "math/conventions.h"
#include "math/portable.h"
#include "math/range.h"

namespace parhelion {

/// A place in the picture, or none where `inside` does not hold; of the lanes of T.
template <class T>
struct PicturePlace {
  MaskOf<T> inside;
  T x, y;
};

/// cos theta, and sin theta over the radius, of the angle theta that appears at a radius of the ideal lens.
struct AxisAngle {
  double cosine, sinePerRadius;
};

namespace projections {

// Full angles given in degrees may end up an ulp above 2 pi.
inline constexpr double kFullAngleSlack = 1.0 + 1e-12;

// Field of view at the very limit of a projection: lost digits must not count as beyond it.
inline constexpr double kRounding = 1e-15;

/// What most projections are not.
struct OrdinaryPicture {
  static constexpr bool isPanorama = false, isFlat = false, showsHemispheres = false, isMirrored = false;
  static constexpr int discs = 1;
};

struct Fisheye : OrdinaryPicture {
  static constexpr bool isFisheye = true, isAzimuthal = true, hasDiagonal = true;
  static constexpr double defaultFieldOfView = 180, defaultElevation = 90;
  static constexpr int defaultWidthPerHeight = 1;
};

/// 1 + cos theta of a unit camera vector without cancellation near the antipode of the axis.
template <class T>
PARHELION_INLINE T onePlusCosine(const Triple<T>& v) {
  const MaskOf<T> behind = v.z <= 0.0;
  const T sum = 1.0 + v.z;
  return anyOf(behind) ? select(behind, (v.x * v.x + v.y * v.y) / (1.0 - v.z), sum) : sum;
}

/// The angle in [0, pi / 2] of this sine; none above 1.
inline std::optional<double> arcsine(double sine) {
  if (sine > 1.0 + kRounding) return std::nullopt;
  return portable::atan2(sine, std::sqrt(std::max(0.0, (1.0 - sine) * (1.0 + sine))));
}

}  // namespace projections

}  // namespace parhelion
