// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "math/conventions.h"

namespace parhelion {

/// Directions about a point of the sun, unit, world. Under a sun in the zenith they are those toward azimuth 0.
struct SunFrame {
  Vec3 ahead;  // level, at the sun's azimuth
  Vec3 left;   // level, across it
  Vec3 up;     // across the direction of the sun, toward the zenith

  explicit SunFrame(const Vec3& toSun) {
    const double level = std::hypot(toSun.x, toSun.y);
    ahead = level > 0.0 ? Vec3(toSun.x / level, toSun.y / level, 0.0) : Vec3(1.0, 0.0, 0.0);
    left = Vec3(-ahead.y, ahead.x, 0.0);
    up = toSun.z * -ahead + Vec3(0.0, 0.0, level);
  }
};

}  // namespace parhelion
