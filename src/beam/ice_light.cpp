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
    nodeShares_.push_back(line.share * line.xyz[1]);
  }
}

IceLight IceLight::continuous(std::vector<double> indexAtShares, std::vector<Tristimulus> colours) {
  IceLight light;
  light.continuous_ = std::move(indexAtShares);
  light.colours_ = std::move(colours);
  light.colours_.resize(light.continuous_.size(), {1.0, 1.0, 1.0});
  const auto [least, most] = std::ranges::minmax(light.continuous_);
  const double last = static_cast<double>(light.continuous_.size() - 1);
  // By the trapezoidal rule over the shares.
  const auto weightOf = [&](std::size_t k) { return (k == 0 || k + 1 == light.continuous_.size() ? 0.5 : 1.0) / last; };
  for (std::size_t k = 0; k < light.colours_.size(); ++k)
    for (std::size_t c = 0; c < light.white_.size(); ++c) light.white_[c] += weightOf(k) * light.colours_[k][c];
  if (!(most > least)) return IceLight({{least, 1.0, light.white_}});
  light.nodes_ = {least, 0.5 * (least + most), most};
  light.nodeShares_.assign(light.nodes_.size(), 0.0);
  for (std::size_t k = 0; k < light.continuous_.size(); ++k) {
    const double weight = weightOf(k);
    const Sample sample = light.between(light.continuous_[k], weight, light.colours_[k]);
    for (int j = 0; j < kMixed; ++j)
      light.nodeShares_[static_cast<std::size_t>(sample.node[j])] += weight * sample.part[j] * sample.xyz[1];
  }
  return light;
}

IceLight::Sample IceLight::between(double index, double share, const Tristimulus& xyz) const {
  // Lagrange's parabola through three nodes.
  const auto part = [&](int a, int b, int c) {
    const double at = nodes_[static_cast<std::size_t>(a)], first = nodes_[static_cast<std::size_t>(b)],
                 second = nodes_[static_cast<std::size_t>(c)];
    return (index - first) * (index - second) / ((at - first) * (at - second));
  };
  return {index, share, xyz, {0, 1, 2}, {part(0, 1, 2), part(1, 0, 2), part(2, 0, 1)}};
}

void IceLight::sample(double start, std::vector<Sample>& samples) const {
  samples.clear();
  if (!isContinuous()) {
    for (std::size_t k = 0; k < lines_.size(); ++k)
      samples.push_back(
          {lines_[k].index, lines_[k].share, lines_[k].xyz, {static_cast<int>(k), 0, 0}, {1.0, 0.0, 0.0}});
    return;
  }
  const std::size_t last = continuous_.size() - 1;
  Tristimulus sum{};
  for (int k = 0; k < kSamples; ++k) {
    const double place = (k + start) / kSamples * static_cast<double>(last);
    const std::size_t cell = std::min(static_cast<std::size_t>(place), last - 1);
    const double t = place - static_cast<double>(cell);
    const auto at = [=](double before, double behind) { return (1.0 - t) * before + t * behind; };
    Tristimulus xyz;
    for (std::size_t c = 0; c < xyz.size(); ++c) {
      xyz[c] = at(colours_[cell][c], colours_[cell + 1][c]);
      sum[c] += xyz[c] / kSamples;
    }
    samples.push_back(between(at(continuous_[cell], continuous_[cell + 1]), 1.0 / kSamples, xyz));
  }
  // Together they are as white as all light is: where indices do not matter, nor do the few samples.
  for (Sample& sample : samples)
    for (std::size_t c = 0; c < sum.size(); ++c) sample.xyz[c] *= sum[c] > 0.0 ? white_[c] / sum[c] : 1.0;
}

}  // namespace parhelion
