// SPDX-License-Identifier: Apache-2.0
#include "photo/refine_sky.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "parallel/loops.h"
#include "photo/guided_filter.h"
#include "picture/transfer.h"

namespace parhelion {

namespace {

constexpr int kRadius = 3;              // pixels of the small picture; finer than that the photograph decides
constexpr float kFlatVariance = 1e-4F;  // of square roots of light: a standard deviation of 2 % of white
constexpr float kSnap = 0.06F;          // of either end counts as the end: what noise and texture make of nothing

float root(float light) { return light > 0.0F ? std::sqrt(std::min(light, 1.0F)) : 0.0F; }

// The guide's component for a sample. Floats may have any unit and are exposed like the small picture.
class Guide {
 public:
  explicit Guide(float scale) : scale_(scale) {
    for (std::size_t i = 0; i < codes8_.size(); ++i) codes8_[i] = root(static_cast<float>(srgbDecode8()[i]));
  }
  float operator()(std::uint8_t code) const { return codes8_[code]; }
  float operator()(std::uint16_t code) const { return root(static_cast<float>(srgbDecode16()[code])); }
  float operator()(float light) const { return root(light * scale_); }

 private:
  float scale_;
  std::array<float, 256> codes8_{};
};

// Whether the mask changes within reach of the filter, for each pixel of the small picture.
Region nearEdges(const SkyMask& mask) {
  constexpr int kReach = 2 * kRadius + 1;
  const auto spread = [](const Region& from, int dx, int dy) {
    Region to(from.width(), from.height());
    for (int y = 0; y < from.height(); ++y) {
      for (int x = 0; x < from.width(); ++x) {
        for (int k = -kReach; k <= kReach; ++k) to.at(x, y) |= from.nearest(x + k * dx, y + k * dy);
      }
    }
    return to;
  };
  Region edge(mask.width, mask.height);
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      const std::uint8_t here = mask.sky[edge.index(x, y)];
      const bool right = x + 1 < mask.width && mask.sky[edge.index(x + 1, y)] != here;
      const bool below = y + 1 < mask.height && mask.sky[edge.index(x, y + 1)] != here;
      edge.at(x, y) = right || below || (here != 0 && here != 255) ? 1 : 0;
    }
  }
  return spread(spread(edge, 1, 0), 0, 1);
}

std::uint8_t snapped(float alpha) {
  const float stretched = std::clamp((alpha - kSnap) / (1.0F - 2.0F * kSnap), 0.0F, 1.0F);
  return static_cast<std::uint8_t>(std::lround(255.0F * stretched));
}

float guideScale(const Photograph& photograph, const Image& small) {
  if (!std::holds_alternative<std::vector<float>>(photograph.samples)) return 1.0F;
  double sum = 0.0;
  for (const std::vector<float>* plane : small.rgb()) {
    for (const float light : *plane) sum += std::isfinite(light) ? std::max(static_cast<double>(light), 0.0) : 0.0;
  }
  constexpr double kMeanLight = 0.25;
  return sum > 0.0 ? static_cast<float>(kMeanLight * 3.0 * static_cast<double>(small.pixels()) / sum) : 1.0F;
}

GuidedFilter fitted(const Image& small, const SkyMask& found, float scale) {
  Raster<GuideColour> guide(small.width, small.height);
  Raster<float> alpha(small.width, small.height);
  const auto planes = small.rgb();
  for (std::size_t i = 0; i < guide.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) guide[i][c] = root((*planes[c])[i] * scale);
    alpha[i] = static_cast<float>(found.sky[i]) / 255.0F;
  }
  return {guide, alpha, kRadius, kFlatVariance};
}

}  // namespace

SkyMask refineSky(const Photograph& photograph, const Image& small, const SkyMask& found, int reduction) {
  const float scale = guideScale(photograph, small);
  const GuidedFilter filter = fitted(small, found, scale);
  const Region edges = nearEdges(found);
  const Guide guide(scale);
  SkyMask mask{photograph.width, photograph.height, std::vector<std::uint8_t>(photograph.pixels())};
  const auto refineRow = [&](const auto& samples, int y) {
    for (int x = 0; x < mask.width; ++x) {
      const std::size_t coarse = edges.index(x / reduction, y / reduction);
      const std::size_t i =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width) + static_cast<std::size_t>(x);
      mask.sky[i] = found.sky[coarse];
      if (edges[coarse] == 0) continue;
      const auto* sample = &samples[i * static_cast<std::size_t>(photograph.channels)];
      const auto place = [&](int pixel) { return (static_cast<float>(pixel) + 0.5F) / static_cast<float>(reduction); };
      mask.sky[i] = snapped(filter.at(place(x), place(y), {guide(sample[0]), guide(sample[1]), guide(sample[2])}));
    }
  };
  std::visit([&](const auto& samples) { forRows(mask.height, [&](int y) { refineRow(samples, y); }); },
             photograph.samples);
  return mask;
}

}  // namespace parhelion
