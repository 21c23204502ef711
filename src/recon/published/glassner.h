// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recon/hit_map.h"
#include "recon/recon_settings.h"
#include "recon/watch.h"

namespace parhelion {

/// The mean of several Gaussian means (gaussian.h), of standard deviation 1, 2, 4, ... pixels.
/// Glassner, Computer-generated solar halos and sun dogs, 1996.
Reconstruction glassner(const HitMap& map, const GlassnerSettings& settings, const Watch& watch);

}  // namespace parhelion
