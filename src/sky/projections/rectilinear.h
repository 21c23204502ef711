// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/geometric.hpp>

#include "sky/projections/common.h"

namespace parhelion::projections {

/// r = tan theta: straight lines stay straight.
struct Rectilinear : OrdinaryPicture {
  static constexpr bool isFisheye = false, isAzimuthal = true, isFlat = true, hasDiagonal = true;
  static constexpr Range fieldOfView{0, 180, true, true}, verticalFieldOfView = fieldOfView;
  static constexpr double defaultFieldOfView = 60, defaultElevation = 0;
  static constexpr int defaultWidthPerHeight = 1;

  static double radiusAt(double angle) { return portable::tan(angle); }
  static std::optional<double> angleAt(double radius) { return portable::atan2(radius, 1.0); }

  template <class T>
  static PARHELION_INLINE T radiusPerSine(const Triple<T>& v) {
    return 1.0 / v.z;
  }

  static AxisAngle atSquaredRadius(double r2) {
    const double cosine = 1.0 / std::sqrt(1.0 + r2);
    return {cosine, cosine};
  }

  /// There is a circle only where distortion folds the picture.
  static double circleHeight(double r2) { return r2 / (1.0 + r2 + std::sqrt(1.0 + r2)); }

  /// As two triangles (Van Oosterom & Strackee 1983). The triangles' determinant is the rectangle's area, so nothing
  /// cancels in small pixels.
  static double rectangle(Vec2 lo, Vec2 hi) {
    const double area = (hi.x - lo.x) * (hi.y - lo.y);
    const auto triangle = [area](Vec3 a, Vec3 b, Vec3 c) {
      const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
      const double scale = la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb;
      return 2.0 * portable::atan2(area, scale);
    };
    const Vec3 a{lo.x, lo.y, 1.0}, c{hi.x, hi.y, 1.0};
    return triangle(a, {hi.x, lo.y, 1.0}, c) + triangle(a, c, {lo.x, hi.y, 1.0});
  }
};

}  // namespace parhelion::projections
