// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <set>

#include "hit_maps.h"
#include "recon/methods.h"
#include "recon/published/allebach.h"
#include "recon/published/nearest_hits.h"

namespace parhelion {
namespace {

MethodOnMap voronoiWith(const VoronoiSettings& settings) {
  return [settings](const HitMap& map) { return reconstructHits(map, settings, {}); };
}

/// Squared distance of two pixels, round the torus where edges touch.
int squaredDistance(const HitMap& map, int x, int y, std::size_t hit) {
  int dx = std::abs(static_cast<int>(hit) % map.width() - x), dy = std::abs(static_cast<int>(hit) / map.width() - y);
  if (map.wrapX) dx = std::min(dx, map.width() - dx);
  if (map.wrapY) dy = std::min(dy, map.height() - dy);
  return dx * dx + dy * dy;
}

std::multiset<int> nearestBySearch(const HitMap& map, const std::vector<std::size_t>& hits, int x, int y) {
  std::multiset<int> nearest;
  int best = 1 << 30;
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const int distance = squaredDistance(map, x, y, hits[i]);
    if (distance < best) nearest.clear();
    if (distance <= best) nearest.insert(static_cast<int>(i));
    best = std::min(best, distance);
  }
  return nearest;
}

}  // namespace

TEST_CASE("nearest hits are those that a search of all finds, ties included, whichever edges touch") {
  for (const auto& [width, height] : {std::pair{24, 17}, {16, 16}, {15, 20}, {40, 1}, {1, 8}, {1, 9}, {2, 2}}) {
    for (int edges = 0; edges < 4; ++edges) {
      for (const double density : {0.004, 0.02, 0.1, 0.2, 0.6}) {
        HitMap map = poissonHits(emptySky(width, height), density, static_cast<std::uint64_t>(width + edges));
        map.wrapX = edges % 2 == 1;
        map.wrapY = edges / 2 == 1;
        const NearestHits nearest(map);
        int wrong = 0;
        for (int y = 0; y < height; ++y) {
          for (int x = 0; x < width; ++x) {
            const std::span<const int> found = nearest.of(x, y);
            const std::multiset<int> set(found.begin(), found.end());
            wrong += set == nearestBySearch(map, nearest.pixels(), x, y) ? 0 : 1;
          }
        }
        CAPTURE(width);
        CAPTURE(edges);
        CAPTURE(density);
        CHECK(wrong == 0);
      }
    }
  }
}

TEST_CASE("light over the cells' areas, spread over the cells, is all the light") {
  const HitMap map = poissonHits(emptyDisc(100), 0.05, 12);
  const NearestHits nearest(map);
  const KnownValues known = voronoiCells(map, nearest, HitReading::densities);
  const Reconstruction cells{{nearest.interpolate(known.lights[0])}, {}};
  CHECK(lightOf(cells, map) == doctest::Approx(sumOf(map.hits())).epsilon(1e-12));

  double area = 0.0;
  for (const double cell : known.weights) area += cell;
  CHECK(area == doctest::Approx(sumOf(map.omega)).epsilon(1e-12));
}

TEST_CASE("a mirrored map gives the mirrored picture") {
  constexpr int kSide = 61;
  HitMap map = poissonHits(emptySky(kSide, kSide), 0.03, 13), mirrored = map;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) mirrored.lights[0].at(x, y) = map.lights[0].at(kSide - 1 - x, y);
  }
  const Reconstruction a = reconstructHits(map, VoronoiSettings{}, {}),
                       b = reconstructHits(mirrored, VoronoiSettings{}, {});
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      CHECK(std::abs(a.lights[0].at(x, y) - b.lights[0].at(kSide - 1 - x, y)) < 1e-12);
    }
  }
}

TEST_CASE("the Voronoi method leaves a constant sky constant up to its border, in both readings") {
  for (const HitReading reading : {HitReading::intensities, HitReading::densities}) {
    for (const double period : {1.0, 5.0, 30.0}) {
      CHECK(errorOfConstantSky(voronoiWith({reading, period, 0})) < 1e-9);
      CHECK(errorOfConstantSky(voronoiWith({reading, period, 3})) < 1e-9);
    }
  }
}

TEST_CASE("the Voronoi method bears empty maps, single hits, piles and holes") {
  checkAwkwardMaps(voronoiWith({}));
  checkAwkwardMaps(voronoiWith({HitReading::densities, 6.0, 5}));
}

TEST_CASE("the Voronoi method gives the same bits for any number of threads and filters all lights alike") {
  checkThreadsAndLights(voronoiWith({HitReading::densities, {}, 2}));
}

TEST_CASE("Voronoi densities keep the light of a thin flat sky, after ten iterations within 2 %") {
  for (const std::uint64_t seed : {21U, 22U, 23U}) {
    const HitMap flat = poissonHits(emptySky(128, 128), 0.1, seed);
    CHECK(gain(voronoiWith({}), flat) == doctest::Approx(1.0).epsilon(0.01));
    CHECK(gain(voronoiWith({HitReading::densities, {}, 10}), flat) == doctest::Approx(1.0).epsilon(0.02));
  }
}

TEST_CASE("read as intensities, sparse hits are a grey sky of ones") {
  // The mean of a Poisson count of 0.1 that is not zero is 0.1 / (1 - exp(-0.1)) = 1.051.
  const HitMap flat = poissonHits(emptySky(128, 128), 0.1, 24);
  const double mean =
      lightOf(reconstructHits(flat, VoronoiSettings{HitReading::intensities, {}, 0}, {}), flat) / (128.0 * 128.0);
  CHECK(mean == doctest::Approx(1.051).epsilon(0.03));
}

TEST_CASE("both readings agree where every pixel has many hits") {
  const HitMap dense = poissonHits(emptySky(64, 64), 30.0, 25);
  const Reconstruction intensities = reconstructHits(dense, VoronoiSettings{HitReading::intensities, 6.0, 0}, {});
  const Reconstruction densities = reconstructHits(dense, VoronoiSettings{HitReading::densities, 6.0, 0}, {});
  for (std::size_t i = 0; i < dense.omega.size(); ++i) {
    CHECK(intensities.lights[0][i] == doctest::Approx(densities.lights[0][i]));
  }
}

}  // namespace parhelion
