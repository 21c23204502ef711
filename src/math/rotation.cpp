// SPDX-License-Identifier: Apache-2.0
#include "math/rotation.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "math/portable.h"
#include "math/rotation_columns.h"

namespace parhelion {

Vec3 skyDirection(double azimuth, double elevation) {
  const auto [sinAz, cosAz] = portable::sincos(azimuth);
  const auto [sinEl, cosEl] = portable::sincos(elevation);
  return {cosEl * cosAz, -cosEl * sinAz, sinEl};
}

SkyPoint skyPoint(const Vec3& toSky) {
  const double horizontal = std::sqrt(toSky.x * toSky.x + toSky.y * toSky.y);
  const double azimuth = horizontal > 0.0 ? portable::atan2(-toSky.y, toSky.x) : 0.0;
  return {azimuth <= -kPi ? kPi : azimuth, portable::atan2(toSky.z, horizontal)};
}

double angleBetween(const Vec3& a, const Vec3& b) {
  return portable::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// GLM matrices are given by columns.
Mat3 rotationX(double angle) {
  const auto [s, c] = portable::sincos(angle);
  return Mat3(Vec3(1, 0, 0), Vec3(0, c, s), Vec3(0, -s, c));
}

Mat3 rotationY(double angle) {
  const auto [s, c] = portable::sincos(angle);
  return Mat3(Vec3(c, 0, -s), Vec3(0, 1, 0), Vec3(s, 0, c));
}

Mat3 rotationZ(double angle) {
  const auto [s, c] = portable::sincos(angle);
  return Mat3(Vec3(c, s, 0), Vec3(-s, c, 0), Vec3(0, 0, 1));
}

Mat3 frameAround(const Vec3& axis) {
  // Start from the coordinate axis least parallel to `axis`, so that the cross product cannot vanish.
  const Vec3 start = std::abs(axis.z) < 0.5 ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
  const Vec3 x = glm::normalize(glm::cross(start, axis));
  return Mat3(x, glm::cross(axis, x), axis);
}

}  // namespace parhelion
