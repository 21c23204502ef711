// SPDX-License-Identifier: Apache-2.0
#include "view/dots.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace parhelion {
namespace {

/// The pixels of a dot, from the one in its middle (of an even size: the upper left of the four).
std::vector<std::pair<int, int>> brush(int size) {
  std::vector<std::pair<int, int>> offsets;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const int dx = 2 * x - (size - 1), dy = 2 * y - (size - 1);  // half pixels from the centre
      if (dx * dx + dy * dy <= size * size) offsets.emplace_back(x - (size - 1) / 2, y - (size - 1) / 2);
    }
  return offsets;
}

}  // namespace

Preview dots(const Tally& tally, int size, std::uint8_t ink) {
  if (size < 1 || size > kMaxDotSize) throw std::invalid_argument("a dot has 1 to 64 pixels across");
  const int width = tally.width(), height = tally.height();
  Preview page{width, height, std::vector<std::uint8_t>(3 * static_cast<std::size_t>(tally.pixels()), 255), 0};
  const auto offsets = brush(size);
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) {
    if (tally.hits(pixel) == 0) continue;
    for (const auto& [dx, dy] : offsets) {
      const int x = pixel % width + dx, y = pixel / width + dy;
      if (x < 0 || x >= width || y < 0 || y >= height) continue;
      std::fill_n(page.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * width + x), 3, ink);
    }
  }
  return page;
}

int usualDotSize(const Tally& tally) {
  constexpr int kPixelsADot = 800;
  return std::clamp(std::min(tally.width(), tally.height()) / kPixelsADot, 1, kMaxDotSize);
}

}  // namespace parhelion
