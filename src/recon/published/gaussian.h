// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recon/hit_map.h"
#include "recon/recon_settings.h"
#include "recon/watch.h"

namespace parhelion {

/// One Gaussian for the whole picture: K * light / K * omega, so that a constant sky stays constant up to the border.
Reconstruction gaussian(const HitMap& map, const GaussianSettings& settings, const Watch& watch);

/// The lights under a Gaussian of standard deviation `sigma` (pixels) over omega under the same.
std::vector<Raster<double>> gaussianMeans(const HitMap& map, double sigma);

}  // namespace parhelion
