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

  /// What the latitudes of a rectangle bring to its solid angle, and what its longitudes make of it.
  struct Latitudes {
    double cosine, sine;
    bool any;
  };
  static Latitudes latitudes(double lo, double hi) {
    const double south = std::max(lo, -0.5 * kPi), north = std::min(hi, 0.5 * kPi);
    // sin(north) - sin(south) without cancellation
    return {portable::cos(0.5 * (north + south)), portable::sin(0.5 * (north - south)), north > south};
  }
  static double solidAngle(const Latitudes& latitudes, double lo, double hi) {
    const double longitudes = std::min(hi, kPi) - std::max(lo, -kPi);
    return longitudes > 0.0 && latitudes.any ? longitudes * 2.0 * latitudes.cosine * latitudes.sine : 0.0;
  }

  static double rectangle(Vec2 lo, Vec2 hi) { return solidAngle(latitudes(lo.y, hi.y), lo.x, hi.x); }
};

}  // namespace parhelion::projections
