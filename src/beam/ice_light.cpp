// SPDX-License-Identifier: Apache-2.0
#include "beam/ice_light.h"

#include <algorithm>
#include <stdexcept>

namespace parhelion {

namespace {

// Samples of continuous light for each class and patch, which all start elsewhere.
constexpr int kSamples = 16;

}  // namespace

IceLight::IceLight(const std::vector<IndexShare>& lines) : lines_(lines) {
  if (lines.empty()) throw std::invalid_argument("light needs an index");
  for (const IndexShare& line : lines) {
    nodes_.push_back(line.index);
    nodeShares_.push_back(line.share);
  }
}

IceLight IceLight::continuous(std::vector<double> indexAtShares) {
  IceLight light;
  light.continuous_ = std::move(indexAtShares);
  const auto [least, most] = std::ranges::minmax(light.continuous_);
  if (!(most > least)) return IceLight({{least, 1.0}});
  light.nodes_ = {least, 0.5 * (least + most), most};
  light.nodeShares_.assign(light.nodes_.size(), 0.0);
  // The means of the parts, by the trapezoidal rule over the shares.
  const double last = static_cast<double>(light.continuous_.size() - 1);
  for (std::size_t k = 0; k < light.continuous_.size(); ++k) {
    const double weight = (k == 0 || k + 1 == light.continuous_.size() ? 0.5 : 1.0) / last;
    const Sample sample = light.between(light.continuous_[k], weight);
    for (int j = 0; j < kMixed; ++j)
      light.nodeShares_[static_cast<std::size_t>(sample.node[j])] += weight * sample.part[j];
  }
  return light;
}

IceLight::Sample IceLight::between(double index, double share) const {
  // Lagrange's parabola through three nodes.
  const auto part = [&](int a, int b, int c) {
    const double at = nodes_[static_cast<std::size_t>(a)], first = nodes_[static_cast<std::size_t>(b)],
                 second = nodes_[static_cast<std::size_t>(c)];
    return (index - first) * (index - second) / ((at - first) * (at - second));
  };
  return {index, share, {0, 1, 2}, {part(0, 1, 2), part(1, 0, 2), part(2, 0, 1)}};
}

void IceLight::sample(double start, std::vector<Sample>& samples) const {
  samples.clear();
  if (!isContinuous()) {
    for (std::size_t k = 0; k < lines_.size(); ++k)
      samples.push_back({lines_[k].index, lines_[k].share, {static_cast<int>(k), 0, 0}, {1.0, 0.0, 0.0}});
    return;
  }
  const std::size_t last = continuous_.size() - 1;
  for (int k = 0; k < kSamples; ++k) {
    const double place = (k + start) / kSamples * static_cast<double>(last);
    const std::size_t cell = std::min(static_cast<std::size_t>(place), last - 1);
    const double t = place - static_cast<double>(cell);
    samples.push_back(between((1.0 - t) * continuous_[cell] + t * continuous_[cell + 1], 1.0 / kSamples));
  }
}

}  // namespace parhelion
