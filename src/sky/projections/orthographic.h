// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/edge_integral.h"
#include "sky/projections/common.h"

namespace parhelion::projections {

/// r = sin theta: a hemisphere seen from far away.
struct Orthographic : Fisheye {
  static constexpr Range fieldOfView{0, 180, true}, verticalFieldOfView = fieldOfView;

  static double radiusAt(double angle) { return portable::sin(angle); }
  static std::optional<double> angleAt(double radius) { return arcsine(radius); }

  template <class T>
  static PARHELION_INLINE T radiusPerSine(const Triple<T>&) {
    return all<T>(1.0);
  }

  static AxisAngle atSquaredRadius(double r2) {
    const double r = std::sqrt(r2);
    return {std::sqrt(std::max(0.0, (1.0 - r) * (1.0 + r))), 1.0};
  }

  static double circleHeight(double r2) { return r2 / (1.0 + std::sqrt(std::max(0.0, 1.0 - r2))); }

  /// F = 1 / (1 + sqrt(1 - r^2)). With s = q sin t, q^2 = 1 - c^2, the integrand q cos t / (1 + q cos t) is smooth up
  /// to the rim, where F itself is not.
  static double edgeIntegral(double c, double a, double b) {
    const double q2 = (1.0 - c) * (1.0 + c), q = std::sqrt(q2);
    const auto cosine = [=](double s) { return std::sqrt(std::max(0.0, (q - s) * (q + s))); };
    const double wa = cosine(a), wb = cosine(b);
    // q^2 sin(tb - ta) = b wa - a wb, which cancels where a and b are on the same side.
    const double sum = b * wa + a * wb;
    const double sine = a * b > 0.0 ? q2 * (b - a) * (b + a) / sum : b * wa - a * wb;
    const auto f = [q](double t) {
      const double w = q * portable::cos(t);
      return w / (1.0 + w);
    };
    return integrate(f, portable::atan2(a, wa), portable::atan2(sine, wa * wb + a * b));
  }
};

}  // namespace parhelion::projections
