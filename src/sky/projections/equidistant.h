// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/edge_integral.h"
#include "sky/projections/common.h"

namespace parhelion::projections {

/// r = theta.
struct Equidistant : Fisheye {
  static constexpr Range fieldOfView{0, 360, true}, verticalFieldOfView = fieldOfView;

  static double radiusAt(double angle) { return angle; }
  static std::optional<double> angleAt(double radius) {
    return radius <= kPi * (1.0 + kRounding) ? std::optional(radius) : std::nullopt;
  }

  template <class T>
  static PARHELION_INLINE T radiusPerSine(const Triple<T>& v) {
    const T sine = squareRoot(v.x * v.x + v.y * v.y);
    return select(sine > 0.0, arctangent(sine, v.z) / sine, all<T>(1.0));
  }

  static AxisAngle atSquaredRadius(double r2) {
    const double r = std::sqrt(r2);
    return {portable::cos(r), r > 0.0 ? portable::sin(r) / r : 1.0};
  }

  static double circleHeight(double r2) {
    const double sine = portable::sin(0.5 * std::sqrt(r2));
    return 2.0 * sine * sine;
  }

  /// F = (1 - cos r) / r^2
  static double edgeIntegral(double c, double a, double b) {
    const auto f = [c](double s) {
      const double halfAngle = 0.5 * std::sqrt(c * c + s * s);
      if (halfAngle == 0.0) return 0.5;
      const double sinc = portable::sin(halfAngle) / halfAngle;
      return 0.5 * sinc * sinc;
    };
    return integrate(f, a, b - a);
  }
};

}  // namespace parhelion::projections
