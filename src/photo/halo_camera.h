// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/camera_settings.h"

namespace parhelion {

/// The photograph's camera with pixels `coarseness` times as large, which see all that the photograph sees. A panorama
/// and a picture of hemispheres are taken apart only as far as both sides of each part divide.
CameraSettings haloCamera(const CameraSettings& photo, int coarseness);

/// How large the halo's pixels may be, in the photograph's: a tenth of the sun's disc, which blurs the halo itself by
/// far more; 1 for a point sun (rad).
int finestNeeded(const CameraSettings& photo, double sunDiameter);

}  // namespace parhelion
