// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "picture/photograph.h"
#include "picture/transfer.h"

namespace parhelion {
namespace {

/// Sums rows into the squares they belong to. `linearOf` decodes a sample.
template <typename Sample, typename LinearOf>
void reduce(const std::vector<Sample>& samples, const Photograph& photograph, int reduction, Image& image,
            LinearOf linearOf) {
  const std::array planes{image.channels[0].samples.data(), image.channels[1].samples.data(),
                          image.channels[2].samples.data()};
  std::vector<std::array<double, 3>> sums(static_cast<std::size_t>(image.width));
  const Sample* from = samples.data();
  for (int row = 0; row < image.height; ++row) {
    std::fill(sums.begin(), sums.end(), std::array<double, 3>{});
    const int rows = std::min(reduction, photograph.height - row * reduction);
    for (int y = 0; y < rows; ++y) {
      for (int column = 0; column < image.width; ++column) {
        auto& sum = sums[static_cast<std::size_t>(column)];
        const int columns = std::min(reduction, photograph.width - column * reduction);
        for (int x = 0; x < columns; ++x, from += photograph.channels) {
          for (std::size_t c = 0; c < 3; ++c) sum[c] += linearOf(from[c]);
        }
      }
    }
    for (int column = 0; column < image.width; ++column) {
      const int pixels = rows * std::min(reduction, photograph.width - column * reduction);
      const std::size_t at =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(column);
      for (std::size_t c = 0; c < 3; ++c) {
        planes[c][at] = static_cast<float>(sums[static_cast<std::size_t>(column)][c] / pixels);
      }
    }
  }
}

struct Decode {
  const Photograph& photograph;
  int reduction;
  Image& image;

  void operator()(const std::vector<std::uint8_t>& samples) const {
    reduce(samples, photograph, reduction, image, [&table = srgbDecode8()](std::uint8_t code) { return table[code]; });
  }
  void operator()(const std::vector<std::uint16_t>& samples) const {
    reduce(samples, photograph, reduction, image,
           [&table = srgbDecode16()](std::uint16_t code) { return table[code]; });
  }
  void operator()(const std::vector<float>& samples) const {
    reduce(samples, photograph, reduction, image, [](float linear) { return std::isfinite(linear) ? linear : 0.0F; });
  }
};

}  // namespace

Image linearImage(const Photograph& photograph, int reduction) {
  assert(reduction >= 1);
  Image image{(photograph.width - 1) / reduction + 1, (photograph.height - 1) / reduction + 1, {}};
  for (const char* name : {"R", "G", "B"}) image.add(name);
  std::visit(Decode{photograph, reduction, image}, photograph.samples);
  return image;
}

}  // namespace parhelion
