// SPDX-License-Identifier: Apache-2.0
#include "picture/picture_layers.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <stdexcept>

namespace parhelion {

std::vector<std::string> layersOf(const Image& image) {
  constexpr std::string_view kRed = ".R";
  std::vector<std::string> layers;
  for (const Channel& channel : image.channels) {
    if (!channel.name.ends_with(kRed) || channel.name.size() == kRed.size()) continue;
    const std::string layer = channel.name.substr(0, channel.name.size() - kRed.size());
    if (image.find(layer + ".G") && image.find(layer + ".B")) layers.push_back(layer);
  }
  return layers;
}

Image takeLayers(Image& image) {
  Image taken{image.width, image.height, {}};
  const std::vector<std::string> layers = layersOf(image);
  const auto isOfLayer = [&](const Channel& channel) {
    const std::size_t dot = channel.name.rfind('.');
    return dot != std::string::npos && std::ranges::find(layers, channel.name.substr(0, dot)) != layers.end();
  };
  const auto first = std::ranges::stable_partition(image.channels, std::not_fn(isOfLayer));
  std::ranges::move(first, std::back_inserter(taken.channels));
  image.channels.erase(first.begin(), image.channels.end());
  return taken;
}

Image sumOfLayers(const Image& image, std::span<const std::string> layers) {
  Image sums{image.width, image.height, {}};
  for (const char* colour : {"R", "G", "B"}) {
    std::vector<double> sum(image.pixels(), 0.0);
    for (const std::string& layer : layers) {
      const auto* samples = image.find(layer + "." + colour);
      if (!samples) throw std::invalid_argument("the picture has no layer '" + layer + "'");
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += static_cast<double>((*samples)[i]);
    }
    std::ranges::transform(sum, sums.add(colour).begin(), [](double x) { return static_cast<float>(x); });
  }
  return sums;
}

}  // namespace parhelion
