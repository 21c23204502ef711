// SPDX-License-Identifier: Apache-2.0
#include "recon/adaptive/scatter.h"

#include <algorithm>
#include <cmath>

#include "parallel/loops.h"
#include "recon/adaptive/halving.h"
#include "recon/adaptive/level_kernels.h"
#include "recon/adaptive/near_border.h"
#include "recon/kernel_variance.h"

namespace parhelion {
namespace {

/// Light that leaves one cell of a level through one kernel. Sizes and shapes are sums weighted with the light.
template <std::size_t N>
struct Source {
  Light<N> light{};
  float variance = 0.0F;  // pixels^2
  KernelShape shape;

  void add(const Light<N>& l, float v, KernelShape s) {
    for (std::size_t i = 0; i < N; ++i) light[i] += l[i];
    variance += l[0] * v;
    shape.p += l[0] * s.p;
    shape.q += l[0] * s.q;
  }
};

/// Sorts the pixels' light by level. Level 0 stays empty: its sources are the pixels themselves.
template <std::size_t N>
std::vector<Raster<Source<N>>> sourcesByLevel(const SkyPyramid& sky, const KernelField& field,
                                              const Raster<Light<N>>& light, double hits) {
  const int levels = sky.levels();
  std::vector<int> deepestOfRow(static_cast<std::size_t>(sky.height()));
  forRows(sky.height(), [&](int y) {
    for (int x = 0; x < sky.width(); ++x) {
      if (light.at(x, y)[0] == 0.0F) continue;
      const KernelSite& site = field.pixels().at(x, y);
      int& deepest = deepestOfRow[static_cast<std::size_t>(y)];
      deepest = std::max(deepest, levelOf(kernelVariance(hits, site.density), site.shape.aspect(), levels));
    }
  });
  const int deepest = *std::max_element(deepestOfRow.begin(), deepestOfRow.end());
  std::vector<Raster<Source<N>>> sources(static_cast<std::size_t>(deepest) + 1);
  for (int l = 1; l <= deepest; ++l)
    sources[static_cast<std::size_t>(l)] = {sky.level(l).width(), sky.level(l).height()};

  // Bands of rows in parallel, each a whole number of the largest cells.
  const int band = 1 << deepest;
  forRows((sky.height() + band - 1) / band, [&](int b) {
    for (int y = b * band; y < std::min((b + 1) * band, sky.height()); ++y) {
      for (int x = 0; x < sky.width(); ++x) {
        const Light<N>& here = light.at(x, y);
        if (here[0] == 0.0F) continue;
        const KernelSite& site = field.pixels().at(x, y);
        const float variance = kernelVariance(hits, site.density);
        const int l = levelOf(variance, site.shape.aspect(), levels);
        if (l > 0) sources[static_cast<std::size_t>(l)].at(x >> l, y >> l).add(here, variance, site.shape);
      }
    }
  });
  return sources;
}

template <std::size_t N>
void splat(Raster<Light<N>>& out, const Kernel& kernel, int x, int y, const Light<N>& light) {
  const int top = std::max(-kernel.rowReach(), -y), bottom = std::min(kernel.rowReach(), out.height() - 1 - y);
  for (int dy = top; dy <= bottom; ++dy) {
    const Kernel::Row row = kernel.row(dy);
    const int from = std::max(x + row.from, 0), to = std::min(x + row.from + row.count, out.width());
    const float* weights = row.weights + (from - x - row.from);
    float* cells = out.row(y + dy)[0].data() + static_cast<std::size_t>(from) * N;
    for (int i = 0; i < to - from; ++i, cells += N) {
      for (std::size_t c = 0; c < N; ++c) cells[c] += weights[i] * light[c];
    }
  }
}

/// Calls f(x, y) for every cell, in an order that lets f write up to kMaxReach cells away: tiles that far apart in
/// parallel, their neighbours in later rounds. So every cell sums its light in the same order for any number of
/// threads.
template <class F>
void forSpreadingCells(int width, int height, const F& f) {
  constexpr int kTile = 128;
  static_assert(kTile >= 2 * KernelBank::kMaxReach);
  const int columns = (width + kTile - 1) / kTile, rows = (height + kTile - 1) / kTile;
  for (int round = 0; round < 4; ++round) {
    const int firstColumn = round % 2, firstRow = round / 2;
    const int across = (columns - firstColumn + 1) / 2, down = (rows - firstRow + 1) / 2;
    forEach(across * down, [&](int tile) {
      const int x0 = (firstColumn + 2 * (tile % across)) * kTile, y0 = (firstRow + 2 * (tile / across)) * kTile;
      for (int y = y0; y < std::min(y0 + kTile, height); ++y) {
        for (int x = x0; x < std::min(x0 + kTile, width); ++x) f(x, y);
      }
    });
  }
}

/// Solid angle per cell as the kernels spread it: what an even sky would look like. It falls short of the true one near
/// the border; only there it is computed.
Raster<Light<1>> spreadOmega(const NearBorder& near, const SkyLevel& sky, const Raster<KernelSite>& sites, double hits,
                             int level) {
  Raster<Light<1>> spread(sky.width(), sky.height());
  forSpreadingCells(sky.width(), sky.height(), [&](int x, int y) {
    const int border = sky.border.at(x, y);
    if (border == 0 || !near.isClose(x, y) || !near.within(border, mostReach(sites.at(x, y), hits, level))) return;
    const Kernel& kernel = kernelAt(sites, x, y, hits, level);
    if (near.touchedBy(kernel, x, y)) splat<1>(spread, kernel, x, y, {sky.omega.at(x, y)});
  });
  return spread;
}

/// Light per cell to light per relative solid angle. Away from the border the solid angle is nearly linear over a
/// kernel, and spreading it would change nothing.
template <std::size_t N>
void divideByOmega(Raster<Light<N>>& out, const SkyLevel& sky, const Raster<KernelSite>& sites, double hits,
                   int level) {
  const NearBorder near(out, sky, sites, hits, level);
  const Raster<Light<1>> spread = spreadOmega(near, sky, sites, hits, level);
  const float pixels = pixelsPerCell(level);
  forRows(out.height(), [&](int y) {
    for (int x = 0; x < out.width(); ++x) {
      Light<N>& cell = out.at(x, y);
      float omega = sky.omega.at(x, y);
      if (omega <= 0.0F) cell = {};
      if (cell[0] == 0.0F) continue;
      const float share = near.share(x, y);
      if (share > 0.0F) omega += share * (spread.at(x, y)[0] - omega);
      for (float& l : cell) l /= omega * pixels;
    }
  });
}

/// The light of one level, spread over its cells.
template <std::size_t N>
Raster<Light<N>> spreadLevel(const SkyLevel& sky, const Raster<Source<N>>& sources, int level) {
  Raster<Light<N>> out(sky.width(), sky.height());
  forSpreadingCells(sky.width(), sky.height(), [&](int x, int y) {
    const Source<N>& s = sources.at(x, y);
    if (s.light[0] == 0.0F) return;
    const float per = 1.0F / s.light[0];
    splat(out, kernelFor(s.variance * per, {s.shape.p * per, s.shape.q * per}, level), x, y, s.light);
  });
  return out;
}

/// The light of the pixels with the narrowest kernels, spread over pixels.
template <std::size_t N>
Raster<Light<N>> spreadPixels(const Raster<KernelSite>& sites, const Raster<Light<N>>& light, double hits, int levels) {
  Raster<Light<N>> out(light.width(), light.height());
  forSpreadingCells(light.width(), light.height(), [&](int x, int y) {
    const Light<N>& source = light.at(x, y);
    if (source[0] == 0.0F) return;
    const KernelSite& site = sites.at(x, y);
    const float variance = kernelVariance(hits, site.density);
    if (levelOf(variance, site.shape.aspect(), levels) > 0) return;
    splat(out, kernelFor(variance, site.shape, 0), x, y, source);
  });
  return out;
}

}  // namespace

template <std::size_t N>
Raster<Light<N>> scatter(const SkyPyramid& sky, const KernelField& field, const Raster<Light<N>>& light, double hits) {
  std::vector<Raster<Source<N>>> sources = sourcesByLevel(sky, field, light, hits);
  Raster<Light<N>> coarse;
  for (int l = static_cast<int>(sources.size()) - 1; l >= 0; --l) {
    const SkyLevel& here = sky.level(l);
    Raster<Light<N>> out =
        l > 0 ? spreadLevel(here, sources.back(), l) : spreadPixels(field.pixels(), light, hits, sky.levels());
    sources.pop_back();
    divideByOmega(out, here, field.level(l), hits, l);
    if (coarse.size() > 0) addInterpolated(out, here, coarse, sky.level(l + 1));
    coarse = std::move(out);
  }
  return coarse;
}

template Raster<Light<1>> scatter(const SkyPyramid&, const KernelField&, const Raster<Light<1>>&, double);
template Raster<Light<2>> scatter(const SkyPyramid&, const KernelField&, const Raster<Light<2>>&, double);
template Raster<Light<4>> scatter(const SkyPyramid&, const KernelField&, const Raster<Light<4>>&, double);

}  // namespace parhelion
