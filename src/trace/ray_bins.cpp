// SPDX-License-Identifier: Apache-2.0
#include "trace/ray_bins.h"

#include <algorithm>
#include <cmath>

namespace parhelion {

void RayBins::add(const RayDeposits& ray) {
  for (const auto& [bin, light] : ray.all()) {
    sums_[bin] += toFixed(light);
    squares_[bin] += toFixed(light * light, kSquareScale);
  }
}

void RayBins::merge(const RayBins& other) {
  for (int i = 0; i < size(); ++i) {
    sums_[i] += other.sums_[i];
    squares_[i] += other.squares_[i];
  }
}

double RayBins::error(int bin, std::uint64_t rays) const {
  const double sum = light(bin), squares = fromFixed(squares_[bin], kSquareScale);
  return rays > 0 ? std::sqrt(std::max(0.0, squares - sum * sum / static_cast<double>(rays))) : 0.0;
}

}  // namespace parhelion
