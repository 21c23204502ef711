// SPDX-License-Identifier: Apache-2.0
#include "beam/ice_light.h"

#include <algorithm>
#include <stdexcept>

namespace parhelion {

namespace {

// Parts of continuous light, of as much each.
constexpr std::size_t kSegments = 8;

}  // namespace

IceLight::IceLight(const std::vector<IndexShare>& lines) {
  if (lines.empty()) throw std::invalid_argument("light needs an index");
  for (std::size_t k = 0; k < lines.size(); ++k) {
    nodes_.push_back(lines[k].index);
    nodeShares_.push_back(lines[k].share);
    samples_.push_back({lines[k].index, {static_cast<int>(k), 0, 0}, {1.0, 0.0, 0.0}});
    segments_.push_back({k, k, lines[k].share, {}});
  }
}

IceLight IceLight::continuous(const std::vector<double>& indexAtShares) {
  const auto [least, most] = std::ranges::minmax(indexAtShares);
  if (!(most > least)) return IceLight({{least, 1.0}});
  const auto indexAt = [&](double share) {
    const double place = share * static_cast<double>(indexAtShares.size() - 1);
    const std::size_t cell = std::min(static_cast<std::size_t>(place), indexAtShares.size() - 2);
    return indexAtShares[cell] + (place - static_cast<double>(cell)) * (indexAtShares[cell + 1] - indexAtShares[cell]);
  };
  IceLight light;
  light.nodes_ = {least, 0.5 * (least + most), most};
  light.nodeShares_.assign(light.nodes_.size(), 0.0);
  constexpr double kShare = 1.0 / static_cast<double>(kSegments);
  for (std::size_t k = 0; k <= kSegments; ++k)
    light.samples_.push_back(light.between(indexAt(static_cast<double>(k) * kShare)));
  for (std::size_t k = 0; k < kSegments; ++k) {
    Segment segment{k, k + 1, kShare, {}};
    const double from = light.samples_[k].index, width = light.samples_[k + 1].index - from;
    for (std::size_t j = 0; j < Segment::kPlaces; ++j) {
      const double index =
          indexAt((static_cast<double>(k) + (static_cast<double>(j) + 0.5) / Segment::kPlaces) * kShare);
      segment.at[j] = width != 0.0 ? (index - from) / width : 0.0;
      const Sample sample = light.between(index);
      for (std::size_t n = 0; n < kMixed; ++n)
        light.nodeShares_[static_cast<std::size_t>(sample.node[n])] += kShare / Segment::kPlaces * sample.part[n];
    }
    light.segments_.push_back(segment);
  }
  return light;
}

IceLight::Sample IceLight::between(double index) const {
  // Lagrange's parabola through three nodes.
  const auto part = [&](std::size_t a, std::size_t b, std::size_t c) {
    return (index - nodes_[b]) * (index - nodes_[c]) / ((nodes_[a] - nodes_[b]) * (nodes_[a] - nodes_[c]));
  };
  return {index, {0, 1, 2}, {part(0, 1, 2), part(1, 0, 2), part(2, 0, 1)}};
}

}  // namespace parhelion
