// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recon/hit_map.h"
#include "recon/recon_settings.h"
#include "recon/watch.h"

namespace parhelion {

/// Every pixel takes the value of the nearest hit, then a low-pass filter, then iterations that correct by the
/// residual, spread in the same way: of intensities what is missing at the hits, of densities what is missing in their
/// cells. The latter keeps the light, but for what the border's normalisation moves. Sauer & Allebach, Iterative
/// reconstruction of band-limited images from nonuniformly spaced samples, 1987.
Reconstruction voronoi(const HitMap& map, const VoronoiSettings& settings, const Watch& watch);

}  // namespace parhelion
