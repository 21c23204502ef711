// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/projections/common.h"

namespace parhelion::projections {

/// r = 2 tan(theta / 2): small shapes and all circles keep their form.
struct Stereographic : Fisheye {
  static constexpr Range fieldOfView{0, 360, true, true}, verticalFieldOfView = fieldOfView;

  static double radiusAt(double angle) { return 2.0 * portable::tan(0.5 * angle); }
  static std::optional<double> angleAt(double radius) { return 2.0 * portable::atan2(0.5 * radius, 1.0); }

  template <class T>
  static PARHELION_INLINE T radiusPerSine(const Triple<T>& v) {
    return 2.0 / onePlusCosine(v);
  }

  static AxisAngle atSquaredRadius(double r2) {
    return {(1.0 - 0.25 * r2) / (1.0 + 0.25 * r2), 1.0 / (1.0 + 0.25 * r2)};
  }

  static double circleHeight(double r2) { return 2.0 * r2 / (4.0 + r2); }

  /// F = 2 / (4 + r^2)
  static double edgeIntegral(double c, double a, double b) {
    const double q2 = 4.0 + c * c, q = std::sqrt(q2);
    return 2.0 / q * portable::atan2((b - a) * q, q2 + a * b);
  }
};

}  // namespace parhelion::projections
