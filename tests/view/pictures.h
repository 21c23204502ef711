// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <random>

#include "view/display.h"

namespace parhelion::test {

/// A picture whose components are what `value` says at (channel, x, y).
inline Display display(int width, int height, const std::function<double(int, int, int)>& value) {
  Display picture{width, height, {}};
  for (int c = 0; c < 3; ++c)
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        picture.planes[static_cast<std::size_t>(c)].push_back(static_cast<float>(value(c, x, y)));
  return picture;
}

/// The same of linear light.
inline Image light(int width, int height, const std::function<double(int, int, int)>& value) {
  Image image{width, height, {}};
  const Display planes = display(width, height, value);
  for (std::size_t c = 0; c < 3; ++c) image.add(std::array{"R", "G", "B"}[c]) = planes.planes[c];
  return image;
}

/// A photograph of 8 bits of random colours.
inline Photograph noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  Photograph photograph;
  photograph.width = width;
  photograph.height = height;
  std::vector<std::uint8_t> samples(3 * photograph.pixels());
  for (std::uint8_t& sample : samples) sample = static_cast<std::uint8_t>(random() & 255U);
  photograph.samples = std::move(samples);
  return photograph;
}

}  // namespace parhelion::test
