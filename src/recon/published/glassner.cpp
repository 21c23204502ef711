// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "recon/methods.h"
#include "recon/published/gaussian.h"

namespace parhelion {

Reconstruction reconstructHits(const HitMap& map, const GlassnerSettings& settings, const Watch& watch) {
  std::vector<Raster<double>> mean(map.lights.size(), Raster<double>(map.width(), map.height()));
  for (int scale = 0; scale < settings.scales; ++scale) {
    watch.at(static_cast<double>(scale) / settings.scales);
    const std::vector<Raster<double>> means = gaussianMeans(map, std::ldexp(1.0, scale));
    for (std::size_t k = 0; k < mean.size(); ++k) {
      for (std::size_t i = 0; i < mean[k].size(); ++i) mean[k][i] += means[k][i] / settings.scales;
    }
  }
  return {std::move(mean), {}};
}

}  // namespace parhelion
