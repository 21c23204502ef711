// SPDX-License-Identifier: Apache-2.0
#include "recon/methods.h"
#include "recon/published/allebach.h"
#include "recon/published/filter_size.h"
#include "recon/published/low_pass.h"

namespace parhelion {

Reconstruction reconstructHits(const HitMap& map, const MarvastiSettings& settings, const Watch& watch) {
  watch.at(0.0);
  const KnownValues known = hitPixels(map);
  const double period = settings.period.value_or(sizeByHits(map, kMarvastiPeriod));
  const SkyLowPass filter(map, period);
  const auto spread = [&](const std::vector<std::vector<double>>& values) {
    std::vector<Raster<double>> light(values.size(), Raster<double>(map.width(), map.height()));
    for (std::size_t k = 0; k < values.size(); ++k) {
      for (std::size_t i = 0; i < known.pixels.size(); ++i) light[k][known.pixels[i]] = values[k][i] * known.weights[i];
    }
    return filter(light);
  };
  Reconstruction result =
      allebach(known, valuesAt(known.pixels), spread, settings.iterations, settings.relaxation, watch);
  result.remarks.insert(result.remarks.begin(), sizeRemark("period", period));
  return result;
}

}  // namespace parhelion
