// SPDX-License-Identifier: Apache-2.0
#include "view/colour_difference.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace parhelion {
namespace {

constexpr double kTail = 0.01;              // share of the pixels that may be cut off at either end
constexpr std::uint8_t kCountsAsSky = 128;  // of 255

/// The value below which a share of the others lie. Reorders them.
double quantile(std::vector<float>& values, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

std::vector<float> countedDifferences(const Display& picture, std::span<const std::uint8_t> sky) {
  const auto& [red, green, blue] = picture.planes;
  std::vector<float> counted;
  counted.reserve(red.size());
  for (std::size_t i = 0; i < red.size(); ++i) {
    const bool black = red[i] == 0.0F && green[i] == 0.0F && blue[i] == 0.0F;
    if (!black && (sky.empty() || sky[i] >= kCountsAsSky)) counted.push_back(red[i] - blue[i]);
  }
  return counted;
}

}  // namespace

ColourDifference redMinusBlue(Display picture, std::optional<double> gain, std::span<const std::uint8_t> sky) {
  if (!sky.empty() && sky.size() != picture.pixels())
    throw std::invalid_argument("the mask has another size than the picture");
  if (!sky.empty() && std::all_of(sky.begin(), sky.end(), [](std::uint8_t share) { return share < kCountsAsSky; }))
    throw std::invalid_argument("the mask shows no sky");
  std::vector<float> counted = countedDifferences(picture, sky);
  ColourDifference result{std::move(picture), 0.0, gain.value_or(0.0)};
  if (!counted.empty()) {
    result.centre = quantile(counted, 0.5);
    const double below = result.centre - quantile(counted, kTail),
                 above = quantile(counted, 1.0 - kTail) - result.centre;
    const double most = std::max(below, above);
    if (!gain && most > 0.0) result.gain = std::min(kMidGrey, 1.0 - kMidGrey) / most;
  }

  auto& [red, green, blue] = result.picture.planes;
  for (std::size_t i = 0; i < red.size(); ++i) {
    const double difference = static_cast<double>(red[i] - blue[i]) - result.centre;
    red[i] = static_cast<float>(std::clamp(kMidGrey + result.gain * difference, 0.0, 1.0));
  }
  green = blue = red;
  return result;
}

}  // namespace parhelion
