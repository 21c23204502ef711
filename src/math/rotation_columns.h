// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/turn.h"

namespace parhelion {

/// The columns of a rotation matrix, of one rotation or of one in each lane of T.
template <class T>
struct RotationColumns {
  Triple<T> x, y, z;
};

/// The crystal-to-world rotation of a crystal whose c axis points to zenith angle `zenith` and sky azimuth `azimuth`,
/// from the sines and cosines of its angles. The crystal is turned by `roll` about that axis. At roll 0 the normals of
/// faces 3 and 6 lie in the vertical plane through the c axis.
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

}  // namespace parhelion
