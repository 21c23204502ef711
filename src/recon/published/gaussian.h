// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recon/hit_map.h"
#include "recon/watch.h"

namespace parhelion {

/// The lights under a Gaussian of standard deviation `sigma` (pixels) over omega under the same.
std::vector<Raster<double>> gaussianMeans(const HitMap& map, double sigma);

}  // namespace parhelion
