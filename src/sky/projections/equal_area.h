// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/projections/common.h"

namespace parhelion::projections {

/// r = 2 sin(theta / 2): equal parts of the sky have equal areas.
struct EqualArea : Fisheye {
  static constexpr Range fieldOfView{0, 360, true}, verticalFieldOfView = fieldOfView;

  static double radiusAt(double angle) { return 2.0 * portable::sin(0.5 * angle); }
  static std::optional<double> angleAt(double radius) {
    const std::optional<double> half = arcsine(0.5 * radius);
    return half ? std::optional(2.0 * *half) : std::nullopt;
  }

  template <class T>
  static PARHELION_INLINE T radiusPerSine(const Triple<T>& v) {
    return squareRoot(2.0 / onePlusCosine(v));
  }

  static AxisAngle atSquaredRadius(double r2) { return {1.0 - 0.5 * r2, std::sqrt(std::max(0.0, 1.0 - 0.25 * r2))}; }

  static double circleHeight(double r2) { return 0.5 * r2; }
  static double edgeIntegral(double /*c*/, double a, double b) { return 0.5 * (b - a); }  // F = 1/2
};

}  // namespace parhelion::projections
