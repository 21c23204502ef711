// SPDX-License-Identifier: Apache-2.0
#pragma once

// From a picture to one of half its resolution, and back.

#include <algorithm>
#include <array>
#include <cstddef>

#include "parallel/loops.h"
#include "recon/adaptive/sky_pyramid.h"

namespace parhelion {

/// How many cells of 2 cover so many; the last may cover but one.
inline int halfOf(int cells) { return (cells + 1) / 2; }

/// Of `coarse` cells in a row the one whose centre is next nearest to that of a finer cell x; the nearest is x / 2.
inline int nextNearest(int x, int coarse) { return std::clamp(x / 2 + (x % 2 == 0 ? -1 : 1), 0, coarse - 1); }

/// A raster of half the resolution of one of width x height cells. Calls add(cell, x, y) for each cell (x, y) of the
/// finer one with that of the coarser one that it lies in: row by row, rows of coarser cells in parallel.
template <class T, class F>
Raster<T> gathered(int width, int height, const F& add) {
  Raster<T> coarse(halfOf(width), halfOf(height));
  forRows(coarse.height(), [&](int y) {
    for (int fy = 2 * y; fy < std::min(2 * y + 2, height); ++fy) {
      for (int x = 0; x < width; ++x) add(coarse.at(x / 2, y), x, fy);
    }
  });
  return coarse;
}

/// The sums over cells of 2 x 2, for light.
template <class T, std::size_t N>
Raster<std::array<T, N>> halved(const Raster<std::array<T, N>>& fine) {
  return gathered<std::array<T, N>>(fine.width(), fine.height(), [&](std::array<T, N>& cell, int x, int y) {
    for (std::size_t c = 0; c < N; ++c) cell[c] += fine.at(x, y)[c];
  });
}

/// Adds `scale` times the values of a coarser level, interpolated between the centres of its cells, each counting by
/// the sky it shows: else the light of a cell that the border leaves but a sliver of would come back once for every
/// pixel beside it. Cells without sky stay as they are.
template <std::size_t N>
void addInterpolated(Raster<std::array<float, N>>& fine, const SkyLevel& fineSky,
                     const Raster<std::array<float, N>>& coarse, const SkyLevel& coarseSky, float scale = 1.0F) {
  forRows(fine.height(), [&](int y) {
    const int y0 = y / 2, y1 = nextNearest(y, coarse.height());
    for (int x = 0; x < fine.width(); ++x) {
      if (fineSky.omega.at(x, y) <= 0.0F) continue;
      const int x0 = x / 2, x1 = nextNearest(x, coarse.width());
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
