// SPDX-License-Identifier: Apache-2.0
#include "photo/sky_colours.h"

#include <algorithm>
#include <cmath>

#include "math/portable.h"

namespace parhelion {

namespace {

constexpr double kBrightShare = 0.95;        // of the pixels are darker than what counts as bright
constexpr float kBrightLight = 0.8F;         // what that is exposed to
constexpr float kLargestLight = 1.2F;        // the sun's surroundings are cut here
constexpr float kVisibleStep = 0.012F;       // of square roots: 2.4 % of white
constexpr float kNoiseStep = 2.0F;           // standard deviations of the noise
constexpr double kQuietShare = 0.25;         // of the pixels have no detail worth speaking of; the noise is theirs
constexpr double kQuietQuantile = 0.32;      // of a normal deviate's absolute value, at that share
constexpr int kBoxes = 16;                   // along each axis of the histogram
constexpr float kLastBox = kBoxes - 1.001F;  // a little less than its number, so that box + 1 is still one
constexpr float kUnseen = 0.02F;             // pixels that every box has at least

float exposure(const Image& linear) {
  const auto planes = linear.rgb();
  std::vector<float> largest(linear.pixels());
  for (std::size_t i = 0; i < largest.size(); ++i) {
    const float light = std::max({(*planes[0])[i], (*planes[1])[i], (*planes[2])[i]});
    largest[i] = std::isfinite(light) ? std::max(light, 0.0F) : 0.0F;
  }
  const auto bright = largest.begin() + static_cast<std::ptrdiff_t>(kBrightShare * static_cast<double>(largest.size()));
  std::nth_element(largest.begin(), bright, largest.end());
  return *bright > 0.0F ? kBrightLight / *bright : 1.0F;
}

// Standard deviation by the mask of Immerkaer 1996, "Fast noise variance estimation", which straight edges and slopes
// leave alone; of its quietest quarter, so that detail does not count as noise.
double noiseOf(const Raster<Opponent>& colours) {
  std::vector<float> detail;
  for (int y = 1; y + 1 < colours.height(); ++y) {
    for (int x = 1; x + 1 < colours.width(); ++x) {
      const auto light = [&](int dx, int dy) { return colours.at(x + dx, y + dy)[0]; };
      detail.push_back(std::abs(light(-1, -1) + light(1, -1) + light(-1, 1) + light(1, 1) + 4.0F * light(0, 0) -
                                2.0F * (light(-1, 0) + light(1, 0) + light(0, -1) + light(0, 1))));
    }
  }
  if (detail.empty()) return 0.0;
  const auto quiet = detail.begin() + static_cast<std::ptrdiff_t>(kQuietShare * static_cast<double>(detail.size()));
  std::nth_element(detail.begin(), quiet, detail.end());
  constexpr double kMaskGain = 6.0;  // square root of the sum of the mask's squares
  return *quiet / (kQuietQuantile * kMaskGain);
}

}  // namespace

float squaredDistance(const Opponent& a, const Opponent& b) {
  const float l = a[0] - b[0], r = a[1] - b[1], y = a[2] - b[2];
  return l * l + r * r + y * y;
}

SkyScene skyScene(const Image& linear) {
  const auto planes = linear.rgb();
  const float scale = exposure(linear);
  SkyScene scene{{linear.width, linear.height}, 0.0F};
  for (std::size_t i = 0; i < linear.pixels(); ++i) {
    std::array<float, 3> root{};
    for (std::size_t c = 0; c < 3; ++c) {
      const float light = (*planes[c])[i] * scale;
      root[c] = light > 0.0F ? std::sqrt(std::min(light, kLargestLight)) : 0.0F;
    }
    scene.colours[i] = {0.25F * (root[0] + 2.0F * root[1] + root[2]), root[0] - root[1],
                        root[2] - 0.5F * (root[0] + root[1])};
  }
  scene.step = std::max(kVisibleStep, kNoiseStep * static_cast<float>(noiseOf(scene.colours)));
  return scene;
}

namespace {

// The eight boxes about a colour and their weights.
template <class F>
void eachBox(const Opponent& colour, const F& f) {
  const std::array place{colour[0] / 1.1F * kBoxes - 0.5F, (colour[1] + 0.5F) * kBoxes - 0.5F,
                         (colour[2] + 0.5F) * kBoxes - 0.5F};
  std::array<std::size_t, 3> box{};
  std::array<float, 3> part{};
  for (std::size_t c = 0; c < 3; ++c) {
    const float inside = std::clamp(place[c], 0.0F, kLastBox);
    box[c] = static_cast<std::size_t>(inside);
    part[c] = inside - static_cast<float>(box[c]);
  }
  for (std::size_t corner = 0; corner < 8; ++corner) {
    float weight = 1.0F;
    std::size_t index = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t upper = corner >> c & 1U;
      weight *= upper != 0 ? part[c] : 1.0F - part[c];
      index = index * kBoxes + box[c] + upper;
    }
    f(index, weight);
  }
}

}  // namespace

ColourHistogram::ColourHistogram() : boxes_(kBoxes * kBoxes * kBoxes) {}

void ColourHistogram::add(const Opponent& colour) {
  eachBox(colour, [&](std::size_t i, float weight) { boxes_[i] += weight; });
  total_ += 1.0;
}

double ColourHistogram::density(const Opponent& colour) const {
  double sum = 0.0;
  eachBox(colour, [&](std::size_t i, float weight) { sum += weight * (boxes_[i] + kUnseen); });
  return sum / (total_ + kUnseen * static_cast<double>(boxes_.size()));
}

double ColourHistogram::separation(const ColourHistogram& a, const ColourHistogram& b) {
  if (a.total_ <= 0.0 || b.total_ <= 0.0) return 0.0;
  const double total = a.total_ + b.total_, shareA = a.total_ / total, shareB = b.total_ / total;
  double information = 0.0;
  for (std::size_t i = 0; i < a.boxes_.size(); ++i) {
    const double inA = a.boxes_[i] / total, inB = b.boxes_[i] / total;
    if (inA > 0.0) information += inA * portable::log(inA / ((inA + inB) * shareA));
    if (inB > 0.0) information += inB * portable::log(inB / ((inA + inB) * shareB));
  }
  return information / -(shareA * portable::log(shareA) + shareB * portable::log(shareB));
}

}  // namespace parhelion
