// SPDX-License-Identifier: Apache-2.0
#include "trace/slab_stack.h"

#include <algorithm>
#include <cmath>

namespace parhelion {

namespace {

template <class Settings>
std::vector<std::size_t> named(std::span<const Settings> all, const std::vector<std::string>* names) {
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!names || std::ranges::find(*names, all[i].name) != names->end()) some.push_back(i);
  return some;
}

}  // namespace

SlabStack::SlabStack(const Extinction& all, std::span<const PopulationSettings> populations,
                     std::span<const HazeSettings> hazes, const SlabSettings& settings) {
  const auto add = [&](const std::vector<std::string>* names, double depth) {
    const auto own = named(populations, names), ownHazes = named(hazes, names);
    layers_.push_back({own, ownHazes, depth, names ? all.part(own, ownHazes) : all});
  };
  for (const SlabLayer& layer : settings.layers) add(&layer.populations, layer.opticalDepth);
  if (layers_.empty()) add(nullptr, settings.opticalDepth);
}

double SlabStack::depthAlong(const Vec3& direction, double leastRise) const {
  double vertical = 0.0;
  for (const Layer& layer : layers_) vertical += layer.extinction.at(direction).depth(layer.opticalDepth);
  return vertical / std::max(std::abs(direction.z), leastRise);
}

}  // namespace parhelion
