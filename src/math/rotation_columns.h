// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/turn.h"

namespace parhelion {

/// The columns of a rotation's matrix, for lanes.
template <class T>
struct RotationColumns {
  Triple<T> x, y, z;
};

/// crystalOrientation() from sines and cosines.
template <class T>
PARHELION_INLINE RotationColumns<T> axisRotation(const SineCosine<T>& zenith, const SineCosine<T>& azimuth,
                                                 const SineCosine<T>& roll) {
  // Rz(-azimuth) Ry(zenith) Rz(roll), multiplied out: sky azimuth grows clockwise seen from above, a rotation about +z
  // counter-clockwise.
  const T &sz = zenith.sin, &cz = zenith.cos, &sa = azimuth.sin, &ca = azimuth.cos, &sr = roll.sin, &cr = roll.cos;
  return {{ca * cz * cr + sa * sr, -sa * cz * cr + ca * sr, -sz * cr},
          {-ca * cz * sr + sa * cr, sa * cz * sr + ca * cr, sz * sr},
          {ca * sz, -sa * sz, cz}};
}

/// Rz(azimuth) Rx(tilt) Ry(spin) from sines and cosines: crystal +y stands `tilt` above the horizontal.
template <class T>
PARHELION_INLINE RotationColumns<T> spinRotation(const SineCosine<T>& tilt, const SineCosine<T>& azimuth,
                                                 const SineCosine<T>& spin) {
  const T &st = tilt.sin, &ct = tilt.cos, &sa = azimuth.sin, &ca = azimuth.cos, &ss = spin.sin, &cs = spin.cos;
  return {{ca * cs - sa * st * ss, sa * cs + ca * st * ss, -ct * ss},
          {-sa * ct, ca * ct, st},
          {ca * ss + sa * st * cs, sa * ss - ca * st * cs, ct * cs}};
}

}  // namespace parhelion
