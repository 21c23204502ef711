// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/conventions.h"
#include "math/portable.h"
#include "math/turn.h"

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

/// The crystal-to-world rotation of a crystal whose c axis points to zenith angle `zenith` and sky azimuth `azimuth`.
/// The crystal is turned by `roll` about that axis. At roll 0 the normals of faces 3 and 6 lie in the vertical plane
/// through the c axis. All angles in radians.
Mat3 crystalOrientation(double zenith, double azimuth, double roll);

/// The columns of a rotation matrix, of one rotation or of one in each lane of T.
template <class T>
struct RotationColumns {
  Triple<T> x, y, z;
};

/// crystalOrientation() from the sines and cosines of its angles.
template <class T>
PARHELION_INLINE RotationColumns<T> axisRotation(const SineCosine<T>& zenith, const SineCosine<T>& azimuth,
                                                 const SineCosine<T>& roll) {
  // Rz(-azimuth) Ry(zenith) Rz(roll), multiplied out. The sign is there because sky azimuth grows clockwise seen from
  // above, while a rotation about +z turns counter-clockwise.
  const T &sz = zenith.sin, &cz = zenith.cos, &sa = azimuth.sin, &ca = azimuth.cos, &sr = roll.sin, &cr = roll.cos;
  return {{ca * cz * cr + sa * sr, -sa * cz * cr + ca * sr, -sz * cr},
          {-ca * cz * sr + sa * cr, sa * cz * sr + ca * cr, sz * sr},
          {ca * sz, -sa * sz, cz}};
}

/// Rz(azimuth) Rx(tilt) Ry(spin) from the sines and cosines of its angles. It turns the crystal by `spin` about its +y,
/// and then lifts +y by `tilt` above the horizontal.
template <class T>
PARHELION_INLINE RotationColumns<T> spinRotation(const SineCosine<T>& tilt, const SineCosine<T>& azimuth,
                                                 const SineCosine<T>& spin) {
  const T &st = tilt.sin, &ct = tilt.cos, &sa = azimuth.sin, &ca = azimuth.cos, &ss = spin.sin, &cs = spin.cos;
  return {{ca * cs - sa * st * ss, sa * cs + ca * st * ss, -ct * ss},
          {-sa * ct, ca * ct, st},
          {ca * ss + sa * st * cs, sa * ss - ca * st * cs, ct * cs}};
}

/// A right-handed orthonormal frame as matrix columns (x, y, `axis`). `axis` must be a unit vector.
Mat3 frameAround(const Vec3& axis);

}  // namespace parhelion
