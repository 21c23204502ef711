// SPDX-License-Identifier: Apache-2.0
#pragma once

// Trigonometric fields known at some pixels of a torus, and what the iterative methods recover of them.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "math/conventions.h"
#include "math/portable.h"
#include "parallel/loops.h"
#include "random_stream.h"
#include "recon/published/act.h"
#include "recon/published/allebach.h"
#include "recon/published/low_pass.h"

namespace parhelion {

/// A real field with normal coefficients of all waves up to 1/(2 period): round a torus of 128 pixels and for a period
/// of 8 pixels 197 of them, of degree 8.
inline Raster<double> trigonometricField(int width, int height, double period, std::uint64_t seed) {
  RandomStream random(seed, 0, RandomPurpose::path);
  const auto normal = [&] {
    return std::sqrt(-2.0 * portable::log(random.next())) * portable::cos(2.0 * kPi * random.next());
  };
  Raster<double> field(width, height);
  for (int ky = 0; ky <= height / 2; ++ky) {
    for (int kx = ky == 0 ? 0 : -width / 2; kx <= width / 2; ++kx) {
      const double fx = static_cast<double>(kx) / width, fy = static_cast<double>(ky) / height;
      if (4.0 * period * period * (fx * fx + fy * fy) > 1.0) continue;
      const double cosine = normal(), sine = normal();
      forRows(height, [&](int y) {
        for (int x = 0; x < width; ++x) {
          const auto wave = portable::sincos(2.0 * kPi * (fx * x + fy * y));
          field.at(x, y) += cosine * wave.cos + sine * wave.sin;
        }
      });
    }
  }
  return field;
}

/// A torus of equal pixels of which those with known(x, y, random number) are hit once.
template <class Known>
HitMap sampledTorus(int width, int height, std::uint64_t seed, const Known& known) {
  HitMap map;
  map.omega = Raster<double>(width, height, 1.0);
  map.lights.assign(1, Raster<double>(width, height));
  map.wrapX = map.wrapY = true;
  RandomStream random(seed, 1, RandomPurpose::path);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) map.lights[0].at(x, y) = known(x, y, random.next()) ? 1.0 : 0.0;
  }
  return map;
}

/// The values of a field at the hits of a torus, each standing for its cell.
inline KnownValues samplesOf(const Raster<double>& field, const HitMap& map, const NearestHits& nearest) {
  KnownValues known = voronoiCells(map, nearest, HitReading::intensities);
  for (std::size_t i = 0; i < known.pixels.size(); ++i) known.lights[0][i] = field[known.pixels[i]];
  return known;
}

/// Distance from the pixel farthest from any hit, pixels.
inline double largestGap(const HitMap& map, const NearestHits& nearest) {
  double largest = 0.0;
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) {
      const auto hit = static_cast<int>(nearest.pixels()[static_cast<std::size_t>(nearest.of(x, y)[0])]);
      int dx = std::abs(hit % map.width() - x), dy = std::abs(hit / map.width() - y);
      dx = std::min(dx, map.width() - dx);
      dy = std::min(dy, map.height() - dy);
      largest = std::max(largest, std::sqrt(dx * dx + dy * dy));
    }
  }
  return largest;
}

/// Root mean square of a - b relative to that of b.
inline double relativeError(const Raster<double>& a, const Raster<double>& b) {
  double error = 0.0, size = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    error += (a[i] - b[i]) * (a[i] - b[i]);
    size += b[i] * b[i];
  }
  return std::sqrt(error / size);
}

/// One field, known at some pixels, and its recovery after `steps` steps (the first low-pass is one).
struct Recovery {
  double period;
  Raster<double> field;
  HitMap map;
  NearestHits nearest;
  KnownValues known;
  LowPass filter;

  /// For an ideal low-pass of that period, which should be the field's own.
  Recovery(Raster<double> values, HitMap torus, double lowPassPeriod)
      : period(lowPassPeriod),
        field(std::move(values)),
        map(std::move(torus)),
        nearest(map),
        known(samplesOf(field, map, nearest)),
        filter(idealLowPass(map.width(), map.height(), period)) {}

  double density() const { return static_cast<double>(known.pixels.size()) / static_cast<double>(field.size()); }

  Reconstruction marvasti(int steps, double relaxation) const {
    const auto zeroFilled = [&](const std::vector<std::vector<double>>& values) {
      std::vector<Raster<double>> picture(1, Raster<double>(map.width(), map.height()));
      for (std::size_t i = 0; i < known.pixels.size(); ++i) picture[0][known.pixels[i]] = values[0][i];
      return filter(picture);
    };
    return allebach(known, valuesAt(known.pixels), zeroFilled, steps - 1, relaxation, {});
  }

  Reconstruction voronoi(int steps) const {
    const auto nearestFilled = [&](const std::vector<std::vector<double>>& values) {
      return filter({nearest.interpolate(values[0])});
    };
    return allebach(known, valuesAt(known.pixels), nearestFilled, steps - 1, 1.0, {});
  }

  Reconstruction act(int steps) const { return fitPolynomial(map, known, period, steps, {}); }

  double error(const Reconstruction& result) const { return relativeError(result.lights[0], field); }
};

}  // namespace parhelion
