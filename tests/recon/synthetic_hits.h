// SPDX-License-Identifier: Apache-2.0
#pragma once

// Hit maps with known contents, and what the method of Gonzato & Marchand makes of them.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

#include "math/portable.h"
#include "random_stream.h"
#include "recon/methods.h"
#include "recon/published/gonzato_marchand.h"

namespace parhelion {

inline constexpr KernelFlow kFlows[] = {KernelFlow::scatter, KernelFlow::gather};

/// A picture full of sky with density(x, y) hits in pixel (x, y).
template <class Density>
HitMap hitMap(int width, int height, const Density& density) {
  HitMap map{{Raster<double>(width, height)}, Raster<double>(width, height, 1.0)};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) map.lights[0].at(x, y) = density(x, y);
  }
  return map;
}

/// The same with Poisson numbers of hits, of means below 100.
template <class Density>
HitMap poissonMap(int width, int height, const Density& mean, std::uint64_t seed) {
  return hitMap(width, height, [&](int x, int y) {
    RandomStream random(seed, static_cast<std::uint64_t>(y * width + x), RandomPurpose::path);
    const double limit = portable::exp(-static_cast<double>(mean(x, y)));
    int count = 0;
    for (double product = random.next(); product > limit; product *= random.next()) ++count;
    return count;
  });
}

/// Cuts the sky down to the disc that touches all sides of a square picture, and the hits with it.
inline HitMap inDisc(HitMap map) {
  constexpr int kPoints = 16;  // a side of the grid that samples each pixel
  const double radius = 0.5 * map.width();
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      int inside = 0;
      for (int i = 0; i < kPoints * kPoints; ++i) {
        const double u = x + (i % kPoints + 0.5) / kPoints - radius, v = y + (i / kPoints + 0.5) / kPoints - radius;
        inside += u * u + v * v < radius * radius;
      }
      map.omega.at(x, y) = static_cast<double>(inside) / (kPoints * kPoints);
      map.lights[0].at(x, y) *= map.omega.at(x, y);
    }
  }
  return map;
}

inline GonzatoMarchandSettings withSamples(std::optional<double> samples, KernelFlow flow, int iterations = 0) {
  GonzatoMarchandSettings settings;
  settings.samples = samples;
  settings.flow = flow;
  settings.iterations = iterations;
  return settings;
}

/// The first light of the picture, in hits per relative solid angle.
inline Raster<double> picture(const HitMap& map, const GonzatoMarchandSettings& settings) {
  return reconstructHits(map, settings, {}).lights.front();
}

inline double total(const Raster<double>& grid) {
  double sum = 0.0;
  for (std::size_t i = 0; i < grid.size(); ++i) sum += grid[i];
  return sum;
}

/// Light in a picture over the hits it was made of, less 1.
inline double energyError(const HitMap& map, const Raster<double>& light) {
  double sum = 0.0;
  for (std::size_t i = 0; i < light.size(); ++i) sum += light[i] * map.omega[i];
  return sum / total(map.hits()) - 1.0;
}

/// Largest deviation from 1 in the sky.
inline double unevenness(const HitMap& map, const Raster<double>& light) {
  double worst = 0.0;
  for (std::size_t i = 0; i < light.size(); ++i) {
    if (map.omega[i] > 0.0) worst = std::max(worst, std::abs(light[i] - 1.0));
  }
  return worst;
}

/// Mean, least and greatest of the columns `from` to `to` of a picture.
struct ColumnRange {
  double mean = 0.0, least = 1e300, greatest = -1e300;
};
inline ColumnRange columns(const Raster<double>& grid, int from, int to) {
  ColumnRange range;
  for (int y = 0; y < grid.height(); ++y) {
    for (int x = from; x < to; ++x) {
      const double value = grid.at(x, y);
      range.mean += value / (static_cast<double>(to - from) * grid.height());
      range.least = std::min(range.least, value);
      range.greatest = std::max(range.greatest, value);
    }
  }
  return range;
}

/// Root mean square of a - b.
inline double rmsDifference(const Raster<double>& a, const Raster<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

inline bool sameBits(const Raster<double>& a, const Raster<double>& b) {
  bool same = a.size() == b.size();
  for (std::size_t i = 0; same && i < a.size(); ++i) same = a[i] == b[i];
  return same;
}

}  // namespace parhelion
