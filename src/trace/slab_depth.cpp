// SPDX-License-Identifier: Apache-2.0
#include "trace/slab_depth.h"

#include <algorithm>
#include <cmath>

namespace parhelion {

namespace {

constexpr std::size_t kNodes = 2048;
// The least rise of a way through the slab.
constexpr double kLevel = 1e-9;

}  // namespace

SlabDepth::SlabDepth(const Extinction& extinction, double opticalDepth)
    : extinction_(extinction), opticalDepth_(opticalDepth) {
  if (!extinction.isSameAllAround()) return;
  std::vector<double> all;
  for (std::size_t k = 0; k <= kNodes; ++k) {
    const double root = static_cast<double>(k) / static_cast<double>(kNodes), rise = root * root;
    all.push_back(vertical(Vec3(std::sqrt(std::max(0.0, 1.0 - rise * rise)), 0.0, rise)));
  }
  byRise_ = std::move(all);
}

double SlabDepth::vertical(const Vec3& direction) const { return extinction_.at(direction).depth(opticalDepth_); }

double SlabDepth::along(const Vec3& direction) const {
  const double rise = std::max(std::abs(direction.z), kLevel);
  if (byRise_.empty()) return vertical(direction) / rise;
  const double place = std::sqrt(rise) * static_cast<double>(kNodes);
  const auto node = std::min(static_cast<std::size_t>(place), kNodes - 1);
  return (byRise_[node] + (place - static_cast<double>(node)) * (byRise_[node + 1] - byRise_[node])) / rise;
}

}  // namespace parhelion
