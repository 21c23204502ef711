// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "photo/sky_colours.h"

namespace parhelion {

/// How much of each pixel is sky, 0 to 1: near the region's border by where the pixel's colour lies between those of
/// the sky and the land about it (compositing equation of Porter & Duff 1984), exactly 0 or 1 elsewhere. The region
/// itself follows in each round, so that branches that it missed and sky between them are found, some pixels farther
/// from the border each time.
Raster<float> skyMatte(const SkyScene& scene, Region region, int rounds);

}  // namespace parhelion
