// SPDX-License-Identifier: Apache-2.0
#include "recon/methods.h"
#include "recon/published/allebach.h"
#include "recon/published/filter_size.h"
#include "recon/published/low_pass.h"

namespace parhelion {

Reconstruction reconstructHits(const HitMap& map, const VoronoiSettings& settings, const Watch& watch) {
  watch.at(0.0);
  const NearestHits nearest(map);
  const KnownValues known = voronoiCells(map, nearest, settings.reading);
  const double period = settings.period.value_or(sizeByHits(map, kVoronoiPeriod));
  const SkyLowPass filter(map, period);
  // A density is that of a whole cell. Compared with the picture at the hits, where it peaks, it would lose light.
  const auto cellMeans = [&](Raster<double> picture) {
    for (std::size_t i = 0; i < picture.size(); ++i) picture[i] *= map.omega[i];
    std::vector<double> means = nearest.cellSums(picture);
    for (std::size_t i = 0; i < means.size(); ++i) means[i] /= known.weights[i];
    return means;
  };
  const Sample sample = settings.reading == HitReading::densities ? Sample(cellMeans) : valuesAt(known.pixels);
  const auto spread = [&](const std::vector<std::vector<double>>& values) {
    std::vector<Raster<double>> light;
    for (const std::vector<double>& kind : values) {
      Raster<double>& picture = light.emplace_back(nearest.interpolate(kind));
      for (std::size_t i = 0; i < picture.size(); ++i) picture[i] *= map.omega[i];
    }
    return filter(light);
  };
  Reconstruction result = allebach(known, sample, spread, settings.iterations, 1.0, watch);
  result.remarks.insert(result.remarks.begin(), sizeRemark("period", period));
  return result;
}

}  // namespace parhelion
