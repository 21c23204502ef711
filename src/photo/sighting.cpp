// SPDX-License-Identifier: Apache-2.0
#include "photo/sighting.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "math/portable.h"
#include "math/rotation.h"

namespace parhelion {
namespace {

const Vec3 kZenith{0.0, 0.0, 1.0};

double inHalfOpenTurn(double angle) { return angle <= -kPi ? kPi : angle; }

/// The miss of a vector that should stand at the angle `target` above the plane through the origin with that unit
/// normal. `side` is -1 for a vector on the far side of the half circle it belongs to, where the angle goes on beyond a
/// right angle, else 1.
Miss missOfCircle(const Vec3& normal, double target, double side, const Vec3& toSky) {
  const Vec3 across = glm::cross(toSky, normal);
  const double level = glm::length(across);
  const double angle = portable::atan2(glm::dot(normal, toSky), side * level) - target;
  // At the circle's pole no turn is better than another.
  const Vec3 axis = level > 0.0 ? (side / level) * across : Vec3(0.0);
  return {angle, angle * axis, glm::outerProduct(axis, axis)};
}

}  // namespace

Mat3 cameraToWorld(const CameraAngles& angles) {
  return rotationZ(-angles.azimuth) * rotationY(-angles.elevation) * rotationX(angles.roll);
}

CameraAngles anglesOf(const Mat3& cameraToWorld) {
  const auto [azimuth, elevation] = skyPoint(cameraToWorld[0]);
  // What the matrix still has to do once azimuth and elevation are undone is the roll.
  const Mat3 rolled = rotationY(elevation) * rotationZ(azimuth) * cameraToWorld;
  return {azimuth, elevation, inHalfOpenTurn(portable::atan2(rolled[1].z, rolled[1].y))};
}

Miss missOf(const Sighting& sighting, const Vec3& toSky) {
  if (!sighting.azimuth) return missOfCircle(kZenith, *sighting.elevation, 1.0, toSky);
  if (!sighting.elevation) {
    const Vec3 ahead = skyDirection(*sighting.azimuth, 0.0), right = skyDirection(*sighting.azimuth + 0.5 * kPi, 0.0);
    return missOfCircle(right, 0.0, glm::dot(ahead, toSky) < 0.0 ? -1.0 : 1.0, toSky);
  }
  const Vec3 target = skyDirection(*sighting.azimuth, *sighting.elevation);
  const Vec3 across = glm::cross(target, toSky);
  const double sine = glm::length(across), angle = angleBetween(target, toSky);
  return {angle, sine > 0.0 ? (angle / sine) * across : Vec3(0.0), Mat3(1.0) - glm::outerProduct(toSky, toSky)};
}

MissSum missSum(std::span<const Sighting> sightings, const Mat3& cameraToWorld) {
  MissSum sum;
  for (const Sighting& sighting : sightings) {
    const Miss miss = missOf(sighting, cameraToWorld * sighting.inCamera);
    sum.squares += miss.angle * miss.angle;
    sum.slope += miss.slope;
    sum.curvature += miss.curvature;
  }
  return sum;
}

}  // namespace parhelion
