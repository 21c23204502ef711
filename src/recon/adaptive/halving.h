// SPDX-License-Identifier: Apache-2.0
#pragma once

// From a picture to one of half its resolution, and back.

#include <algorithm>
#include <array>
#include <cstddef>

#include "recon/adaptive/sky_pyramid.h"

namespace parhelion {

/// The sums over cells of 2 x 2, for light.
template <class T, std::size_t N>
Grid<std::array<T, N>> halved(const Grid<std::array<T, N>>& fine) {
  Grid<std::array<T, N>> coarse((fine.width() + 1) / 2, (fine.height() + 1) / 2);
  forRows(coarse.height(), [&](int y) {
    for (int fy = 2 * y; fy < std::min(2 * y + 2, fine.height()); ++fy) {
      for (int x = 0; x < fine.width(); ++x) {
        for (std::size_t c = 0; c < N; ++c) coarse.at(x / 2, y)[c] += fine.at(x, fy)[c];
      }
    }
  });
  return coarse;
}

/// Adds `scale` times the values of a coarser level, interpolated between the centres of its cells, each counting by
/// the sky it shows: else the light of a cell that the border leaves but a sliver of would come back once for every
/// pixel beside it. Cells without sky stay as they are.
template <std::size_t N>
void addInterpolated(Grid<std::array<float, N>>& fine, const SkyLevel& fineSky,
                     const Grid<std::array<float, N>>& coarse, const SkyLevel& coarseSky, float scale = 1.0F) {
  forRows(fine.height(), [&](int y) {
    const int y0 = y / 2, y1 = std::clamp(y0 + (y % 2 == 0 ? -1 : 1), 0, coarse.height() - 1);
    for (int x = 0; x < fine.width(); ++x) {
      if (fineSky.omega.at(x, y) <= 0.0F) continue;
      const int x0 = x / 2, x1 = std::clamp(x0 + (x % 2 == 0 ? -1 : 1), 0, coarse.width() - 1);
      std::array<float, N> sum{};
      float weights = 0.0F;
      const auto take = [&](int cx, int cy, float weight) {
        weight *= coarseSky.coverage.at(cx, cy);
        weights += weight;
        for (std::size_t c = 0; c < N; ++c) sum[c] += weight * coarse.at(cx, cy)[c];
      };
      take(x0, y0, 9.0F);
      take(x1, y0, 3.0F);
      take(x0, y1, 3.0F);
      take(x1, y1, 1.0F);
      for (std::size_t c = 0; c < N; ++c) fine.at(x, y)[c] += sum[c] * (scale / weights);
    }
  });
}

}  // namespace parhelion
