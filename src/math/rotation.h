// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/conventions.h"

namespace parhelion {

/// The unit world vector toward the sky point at `azimuth` and `elevation` (radians, see conventions.h).
Vec3 skyDirection(double azimuth, double elevation);

struct SkyPoint {
  double azimuth;    ///< radians, (-pi, pi], 0 where it is undefined (zenith and nadir)
  double elevation;  ///< radians, [-pi/2, pi/2]
};

/// Azimuth and elevation of the sky point toward the unit world vector `toSky`.
SkyPoint skyPoint(const Vec3& toSky);

/// The angle between two vectors of any length, radians in [0, pi]. It is exact to rounding also near 0 and pi, where
/// an arc cosine is not.
double angleBetween(const Vec3& a, const Vec3& b);

/// Right-handed rotations about the coordinate axes (radians).
Mat3 rotationX(double angle);
Mat3 rotationY(double angle);
Mat3 rotationZ(double angle);

/// A right-handed orthonormal frame as matrix columns (x, y, `axis`). `axis` must be a unit vector.
Mat3 frameAround(const Vec3& axis);

}  // namespace parhelion
