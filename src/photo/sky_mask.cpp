// SPDX-License-Identifier: Apache-2.0
#include "photo/sky_mask.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace parhelion {

namespace {

// A mean of three components as one of 256 levels.
template <class T>
std::uint8_t level(const T* rgb) {
  const double white = std::is_same_v<T, float> ? 1.0 : std::is_same_v<T, std::uint16_t> ? 65535.0 : 255.0;
  const double mean = (static_cast<double>(rgb[0]) + static_cast<double>(rgb[1]) + static_cast<double>(rgb[2])) / 3.0;
  return std::isfinite(mean) ? static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(mean / white, 0.0, 1.0))) : 0;
}

}  // namespace

SkyMask skyMaskOf(const Photograph& picture) {
  SkyMask mask{picture.width, picture.height, std::vector<std::uint8_t>(picture.pixels())};
  const auto channels = static_cast<std::size_t>(picture.channels);
  std::visit(
      [&](const auto& samples) {
        for (std::size_t i = 0; i < mask.sky.size(); ++i) mask.sky[i] = level(&samples[i * channels]);
      },
      picture.samples);
  return mask;
}

SkyMask readSkyMask(const std::filesystem::path& path) {
  PhotographRules rules;
  rules.assumeSrgb = true;  // levels, not colours
  return skyMaskOf(readPhotograph(path, rules));
}

void writeSkyMask(const Output& output, const SkyMask& mask, const std::map<std::string, std::string>& text) {
  std::vector<std::uint8_t> samples(3 * mask.sky.size());
  for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = mask.sky[i / 3];
  Photograph picture;
  picture.width = mask.width;
  picture.height = mask.height;
  picture.samples = std::move(samples);
  writePhotograph(output, picture, text);
}

}  // namespace parhelion
