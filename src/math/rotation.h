// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/conventions.h"

namespace parhelion {

/// Unit world vector toward the sky point at `azimuth` and `elevation` (radians, conventions.h).
Vec3 skyDirection(double azimuth, double elevation);

struct SkyPoint {
  double azimuth;    ///< radians, (-pi, pi], 0 where it is undefined (zenith and nadir)
  double elevation;  ///< radians, [-pi/2, pi/2]
};

/// Azimuth and elevation of the sky point toward the unit world vector `toSky`.
SkyPoint skyPoint(const Vec3& toSky);

/// Angle between two vectors of any length, radians in [0, pi]; exact to rounding near 0 and pi, where acos is not.
double angleBetween(const Vec3& a, const Vec3& b);

/// Right-handed rotations about the coordinate axes (radians).
Mat3 rotationX(double angle);
Mat3 rotationY(double angle);
Mat3 rotationZ(double angle);

/// Crystal-to-world rotation of a crystal whose c axis points to zenith angle `zenith` and sky azimuth `azimuth`,
/// turned by `roll` about that axis. At roll 0 the normals of faces 3 and 6 lie in the vertical plane through the c
/// axis.
Mat3 crystalOrientation(double zenith, double azimuth, double roll);

/// A right-handed orthonormal frame as matrix columns (x, y, `axis`); `axis` is a unit vector.
Mat3 frameAround(const Vec3& axis);

}  // namespace parhelion
