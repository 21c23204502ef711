// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/projections/common.h"

namespace parhelion::projections {

/// x = longitude, y = latitude of the camera's frame: the whole sphere as a map.
struct Equirectangular : OrdinaryPicture {
  static constexpr bool isFisheye = false, isAzimuthal = false, isPanorama = true, hasDiagonal = false;
  static constexpr Range fieldOfView{0, 360, true}, verticalFieldOfView{0, 180, true};
  static constexpr double defaultFieldOfView = 360, defaultElevation = 0;
  static constexpr int defaultWidthPerHeight = 2;

  static double radiusAt(double angle) { return angle; }
  static std::optional<double> angleAt(double radius) {
    return radius <= kPi * (1.0 + kRounding) ? std::optional(radius) : std::nullopt;
  }

  template <class T>
  static PARHELION_INLINE PicturePlace<T> place(const Triple<T>& v) {
    return {v.z == v.z, arctangent(v.x, v.z), arctangent(v.y, squareRoot(v.x * v.x + v.z * v.z))};
  }

  static std::optional<Vec3> direction(Vec2 p) {
    if (std::abs(p.x) > kPi * kFullAngleSlack || std::abs(p.y) > 0.5 * kPi * kFullAngleSlack) return std::nullopt;
    return anywhere(p);
  }

  /// The same, turning on beyond the sphere's seam and poles.
  static Vec3 anywhere(Vec2 p) {
    const auto [sinLon, cosLon] = portable::sincos(p.x);
    const auto [sinLat, cosLat] = portable::sincos(p.y);
    return Vec3(cosLat * sinLon, sinLat, cosLat * cosLon);
  }

  static double rectangle(Vec2 lo, Vec2 hi) {
    const double longitudes = std::min(hi.x, kPi) - std::max(lo.x, -kPi);
    const double south = std::max(lo.y, -0.5 * kPi), north = std::min(hi.y, 0.5 * kPi);
    if (longitudes <= 0.0 || north <= south) return 0.0;
    // sin(north) - sin(south) without cancellation
    return longitudes * 2.0 * portable::cos(0.5 * (north + south)) * portable::sin(0.5 * (north - south));
  }
};

}  // namespace parhelion::projections
