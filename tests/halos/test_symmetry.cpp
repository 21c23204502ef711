// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <glm/matrix.hpp>

#include "halos/comparison.h"
#include "halos/experiment.h"
#include "trace/bundle_bins.h"
#include "trace/sky_map.h"

using namespace parhelion;

namespace {

// Directions in the crystal's frame in cells of equal solid angle. The cell opposite to a cell is a cell again.
constexpr int kRings = 6, kSectors = 12, kCells = kRings * kSectors;

int cellOf(const Vec3& direction) {
  const int ring = std::min(kRings - 1, static_cast<int>(0.5 * (direction.z + 1.0) * kRings));
  const double turn = std::atan2(direction.y, direction.x) / (2.0 * kPi) + 0.5;
  return ring * kSectors + std::min(kSectors - 1, static_cast<int>(turn * kSectors));
}

int opposite(int cell) {
  const int ring = cell / kSectors, sector = cell % kSectors;
  return (kRings - 1 - ring) * kSectors + (sector + kSectors / 2) % kSectors;
}

/// Light that comes to randomly oriented crystals along the directions of one cell and leaves along those of another.
Disagreement againstReversedLight(const PopulationSettings& crystals, std::uint64_t rays) {
  BundleBins flux(kCells * kCells);
  BundleDeposits<double> deposits;
  forEachRay(cloudUnderPointSun(radians(20), {crystals}), rays, [&](const LightPath& path) {
    deposits.clear();
    const int in = cellOf(path.incident.lightDirCrystal);
    for (const Exit& exit : path.exits)
      deposits.add(in * kCells + cellOf(glm::transpose(path.incident.crystalToWorld) * exit.lightDirWorld),
                   exit.energy);
    flux.add(deposits);
  });
  Disagreement sum;
  for (int in = 0; in < kCells; ++in)
    for (int out = 0; out < kCells; ++out) {
      const int there = in * kCells + out, back = opposite(out) * kCells + opposite(in);
      if (there < back) sum.add(flux.light(there), flux.error(there, rays), flux.light(back), flux.error(back, rays));
    }
  return sum;
}

}  // namespace

TEST_CASE("light reversed takes the same ways through crystals: as much goes from in to out as from -out to -in") {
  const PopulationSettings lopsided{"pyramids", 1.0, PyramidSettings{0.5, 0.8, 0.3}, RandomOrientation{}};
  for (const PopulationSettings& crystals :
       {prisms(0.4, RandomOrientation{}), prisms(2.0, RandomOrientation{}), lopsided}) {
    const Disagreement d = againstReversedLight(crystals, 500'000);
    CHECK(d.compared() > 500);
    CHECK(std::abs(d.sigmas()) < 4.0);
  }
}

TEST_CASE("the sky of symmetric crystals is the same to the left and to the right of the sun") {
  const std::vector<PopulationSettings> crystals{
      prisms(0.2, AxisOrientation{Normal{0.0, radians(1)}, kFree, kFree}),
      prisms(2.0, AxisOrientation{Normal{0.5 * kPi, radians(1)}, kFree, kFree}), prisms(1.0, RandomOrientation{}),
      prisms(1.0, LowitzOrientation{})};
  const Cloud cloud({radians(20), radians(0.533), ContinuousSpectrum{}, false}, PublishedIndex{}, crystals);
  SkyMap map(cloud.sun().toCentre(), 60);
  traceRays(cloud, {.rays = 2'000'000}, 0, map);
  Disagreement sum;
  for (int row = 0; row < map.rows(); ++row)
    for (int column = 1; column < map.columns() / 2; ++column) {
      const int mirrored = map.columns() - column;
      sum.add(map.energy(column, row), map.error(column, row), map.energy(mirrored, row), map.error(mirrored, row));
    }
  CHECK(sum.compared() > 500);
  CHECK(std::abs(sum.sigmas()) < 4.0);
}

TEST_CASE(
    "right is right: a column's end that faces 80 degrees to the right of the sun mirrors it 20 degrees to the left") {
  const OrientationSettings pointing = AxisOrientation{FixedValue{0.5 * kPi}, FixedValue{radians(80)}, FixedValue{}};
  int seen = 0;
  forEachRay(cloudUnderPointSun(0.0, {prisms(1.0, pointing)}), 1000, [&](const LightPath& path) {
    if (path.encounters.front().faceNumber != 1) return;
    CHECK(seenAt(path.exits.front().lightDirWorld).azimuth == doctest::Approx(-20.0));
    CHECK(path.exits.front().lightDirWorld.y < 0.0);  // it comes from the left, +y, and goes to the right
    ++seen;
  });
  CHECK(seen > 0);
}
