// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/portable.h"
#include "math/rotation.h"
#include "math/rotation_columns.h"

namespace parhelion {

inline Mat3 matrixOf(const RotationColumns<double>& r) {
  return Mat3(r.x.x, r.x.y, r.x.z, r.y.x, r.y.y, r.y.z, r.z.x, r.z.y, r.z.z);
}

/// axisRotation() from angles (radians).
inline Mat3 crystalOrientation(double zenith, double azimuth, double roll) {
  const auto sineCosine = [](double angle) {
    const auto [s, c] = portable::sincos(angle);
    return SineCosine<double>{s, c};
  };
  return matrixOf(axisRotation(sineCosine(zenith), sineCosine(azimuth), sineCosine(roll)));
}

}  // namespace parhelion
