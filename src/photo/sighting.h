// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>

#include "math/conventions.h"

namespace parhelion {

/// A direction seen by a camera, and what is known of it in the sky: azimuth, elevation or both.
struct Sighting {
  Vec3 inCamera;                             // unit, frame of an unturned camera: x forward, y left, z up
  std::optional<double> azimuth, elevation;  // rad, as in conventions.h

  bool isDirection() const { return azimuth && elevation; }
};

/// How a camera is turned, as CameraSettings say it; radians.
struct CameraAngles {
  double azimuth, elevation, roll;
};

/// From the frame of an unturned camera to the world.
Mat3 cameraToWorld(const CameraAngles& angles);

/// The angles of a rotation, of which the x and y columns need not be quite orthonormal; azimuth and roll in (-pi, pi].
/// At the zenith and the nadir, where only azimuth and roll together mean something, azimuth is what is left of it in
/// the matrix, 0 if nothing is.
CameraAngles anglesOf(const Mat3& cameraToWorld);

/// By how much a sighting is missed, and what turning the camera does about it.
struct Miss {
  double angle;    // rad on the sky: from the direction, or across the circle of that elevation or azimuth, then signed
  Vec3 slope;      // of half the squared angle, by a turn of the world vector
  Mat3 curvature;  // the same squared slope of the angle itself, of both components for a direction
};

/// The miss where `toSky`, a unit world vector, should be what is known of `sighting`. Slopes are exact.
Miss missOf(const Sighting& sighting, const Vec3& toSky);

/// The sums of squares over several sightings by a turned camera.
struct MissSum {
  double squares = 0.0;  // rad^2
  Vec3 slope{0.0};
  Mat3 curvature{0.0};
};
MissSum missSum(std::span<const Sighting> sightings, const Mat3& cameraToWorld);

}  // namespace parhelion
