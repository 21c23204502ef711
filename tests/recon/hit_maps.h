// SPDX-License-Identifier: Apache-2.0
#pragma once

// Hit maps with known contents, and what is asked of every method that filters them.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include <tbb/task_arena.h>

#include "math/portable.h"
#include "random_stream.h"
#include "recon/hit_map.h"
#include "recon/watch.h"

namespace parhelion {

using MethodOnMap = std::function<Reconstruction(const HitMap&)>;

/// A sky of equal pixels without hits.
inline HitMap emptySky(int width, int height, bool wrap = false) {
  HitMap map;
  map.omega = Raster<double>(width, height, 1.0);
  map.lights.assign(1, Raster<double>(width, height));
  map.wrapX = map.wrapY = wrap;
  return map;
}

/// A disc of sky as wide as the square, whose pixels shrink toward the border.
inline HitMap emptyDisc(int side, bool wrap = false) {
  HitMap map = emptySky(side, side, wrap);
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const double r = std::hypot(x + 0.5 - 0.5 * side, y + 0.5 - 0.5 * side) / (0.5 * side);
      map.omega.at(x, y) = r < 1.0 ? 1.2 - 0.4 * r * r : 0.0;
    }
  }
  return map;
}

/// Light density(x, y) per relative solid angle.
template <class Density>
HitMap filled(HitMap map, const Density& density) {
  for (int y = 0; y < map.height(); ++y) {
    for (int x = 0; x < map.width(); ++x) map.lights[0].at(x, y) = density(x, y) * map.omega.at(x, y);
  }
  return map;
}

/// Poisson hits of that mean density.
inline HitMap poissonHits(HitMap map, double density, std::uint64_t seed) {
  RandomStream random(seed, 0, RandomPurpose::path);
  for (std::size_t i = 0; i < map.omega.size(); ++i) {
    const double limit = portable::exp(-density * map.omega[i]);
    double count = 0.0;
    for (double product = random.next(); product > limit; product *= random.next()) ++count;
    map.lights[0][i] = count;
  }
  return map;
}

/// The light of a picture, or of a density per relative solid angle.
inline double sumOf(const Raster<double>& light) {
  double sum = 0.0;
  for (std::size_t i = 0; i < light.size(); ++i) sum += light[i];
  return sum;
}

inline double lightOf(const Reconstruction& result, const HitMap& map) {
  double sum = 0.0;
  for (std::size_t i = 0; i < map.omega.size(); ++i) sum += result.lights[0][i] * map.omega[i];
  return sum;
}

/// Kept light over that of the hits.
inline double gain(const MethodOnMap& method, const HitMap& map) {
  return lightOf(method(map), map) / sumOf(map.hits());
}

inline double least(const Raster<double>& light) {
  double value = light[0];
  for (std::size_t i = 0; i < light.size(); ++i) value = std::min(value, light[i]);
  return value;
}

inline double greatest(const Raster<double>& light) {
  double value = light[0];
  for (std::size_t i = 0; i < light.size(); ++i) value = std::max(value, light[i]);
  return value;
}

inline bool allFinite(const Raster<double>& light) {
  bool finite = true;
  for (std::size_t i = 0; i < light.size(); ++i) finite = finite && std::isfinite(light[i]);
  return finite;
}

inline bool sameBits(const Reconstruction& a, const Reconstruction& b) {
  bool same = a.lights.size() == b.lights.size();
  for (std::size_t k = 0; same && k < a.lights.size(); ++k) {
    for (std::size_t i = 0; i < a.lights[k].size(); ++i) same = same && a.lights[k][i] == b.lights[k][i];
  }
  return same;
}

/// Largest distance from 1 of a reconstructed constant sky, up to the border: a square and a disc, whose edges touch or
/// not.
inline double errorOfConstantSky(const MethodOnMap& method) {
  double error = 0.0;
  for (const bool wrap : {false, true}) {
    for (const HitMap& sky : {emptySky(64, 48, wrap), emptySky(53, 1, wrap), emptyDisc(64, wrap)}) {
      const Reconstruction result = method(filled(sky, [](int, int) { return 1.0; }));
      for (std::size_t i = 0; i < sky.omega.size(); ++i) {
        error = std::max(error, std::abs(result.lights[0][i] - (sky.omega[i] > 0.0 ? 1.0 : 0.0)));
      }
    }
  }
  return error;
}

/// Maps on which methods tend to fail: nothing, no sky, one hit, a pile, a hole. All results must be finite, and 0
/// where there is nothing.
inline void checkAwkwardMaps(const MethodOnMap& method) {
  for (const HitMap& nothing : {emptySky(32, 24), emptyDisc(32, true)}) CHECK(sumOf(method(nothing).lights[0]) == 0.0);

  HitMap noSky = emptySky(16, 16);
  noSky.omega = Raster<double>(16, 16);
  CHECK(sumOf(method(noSky).lights[0]) == 0.0);

  HitMap oneHit = emptySky(256, 256);
  oneHit.lights[0].at(120, 131) = 1.0;
  CHECK(allFinite(method(oneHit).lights[0]));
  CHECK(gain(method, oneHit) == doctest::Approx(1.0).epsilon(0.03));

  HitMap pile = poissonHits(emptySky(128, 128), 0.1, 5);
  pile.lights[0].at(60, 70) = 5000.0;
  CHECK(allFinite(method(pile).lights[0]));
  CHECK(method(pile).lights[0].at(60, 70) > 10.0);

  HitMap hole = poissonHits(emptyDisc(128), 0.5, 6);
  for (int y = 40; y < 80; ++y) {
    for (int x = 40; x < 80; ++x) hole.lights[0].at(x, y) = 0.0;
  }
  CHECK(allFinite(method(hole).lights[0]));
}

/// One thread and two give the same bits, and other lights go through the linear filter that the
/// first alone would.
inline void checkThreadsAndLights(const MethodOnMap& method) {
  HitMap map = poissonHits(emptyDisc(90), 0.3, 7);
  map.lights.push_back(map.lights[0]);
  map.lights.push_back(map.lights[0]);
  for (std::size_t i = 0; i < map.omega.size(); ++i) {
    map.lights[1][i] *= 3.0;
    map.lights[2][i] *= i % 2 == 0 ? 1.0 : -1.0;  // as a difference between halves
  }
  Reconstruction one, two;
  tbb::task_arena(1).execute([&] { one = method(map); });
  tbb::task_arena(2).execute([&] { two = method(map); });
  CHECK(sameBits(one, two));

  HitMap alone = map;
  alone.lights.resize(1);
  const Reconstruction first = method(alone);
  const double size = greatest(first.lights[0]);
  double error = 0.0, difference = 0.0;
  for (std::size_t i = 0; i < map.omega.size(); ++i) {
    error = std::max(error, std::abs(one.lights[0][i] - first.lights[0][i]));
    error = std::max(error, std::abs(one.lights[1][i] - 3.0 * first.lights[0][i]));
    difference = std::max(difference, std::abs(one.lights[2][i]));
  }
  CHECK(error < 1e-9 * size);
  CHECK(difference > 1e-3 * size);
  CHECK(difference < 2.0 * size);
}

}  // namespace parhelion
