// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace parhelion {

/// How many squares of `side` pixels cover so many pixels; the last may reach beyond them.
inline int squaresOver(int pixels, int side) { return (pixels - 1) / side + 1; }

/// Writes the means over squares of `side` x `side` pixels into planes of squaresOver(width, side) x
/// squaresOver(height, side) values. Squares that reach beyond the picture count what is in it. `valuesAt` gives the
/// values of a pixel, numbered row-major, as an array of double, one for each plane.
template <std::size_t N, class F>
void squareMeans(int width, int height, int side, const std::array<float*, N>& means, const F& valuesAt) {
  const int across = squaresOver(width, side), down = squaresOver(height, side);
  const auto columnsOf = [&](int square) { return std::min(side, width - square * side); };
  std::vector<std::array<double, N>> sums(static_cast<std::size_t>(across));
  std::size_t pixel = 0, to = 0;
  for (int row = 0; row < down; ++row) {
    std::fill(sums.begin(), sums.end(), std::array<double, N>{});
    const int rows = std::min(side, height - row * side);
    for (int y = 0; y < rows; ++y) {
      for (int square = 0; square < across; ++square) {
        auto& sum = sums[static_cast<std::size_t>(square)];
        const int columns = columnsOf(square);
        for (int x = 0; x < columns; ++x, ++pixel) {
          const std::array<double, N> values = valuesAt(pixel);
          for (std::size_t c = 0; c < N; ++c) sum[c] += values[c];
        }
      }
    }
    for (int square = 0; square < across; ++square, ++to) {
      const auto& sum = sums[static_cast<std::size_t>(square)];
      for (std::size_t c = 0; c < N; ++c) means[c][to] = static_cast<float>(sum[c] / (rows * columnsOf(square)));
    }
  }
}

}  // namespace parhelion
