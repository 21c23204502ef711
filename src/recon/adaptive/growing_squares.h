// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "recon/adaptive/sky_pyramid.h"

namespace parhelion {

/// First guess of the light per relative solid angle: around every pixel of the sky a square grows until it holds
/// `enough` light, or all there is. `light` is in whatever unit, exact; 0 where there is no sky.
Raster<float> growingSquares(const SkyPyramid& sky, const Raster<std::int64_t>& light, std::int64_t enough);

}  // namespace parhelion
