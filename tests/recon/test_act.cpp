// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "band_limited_field.h"
#include "hit_maps.h"
#include "recon/methods.h"

namespace parhelion {
namespace {

MethodOnMap actWith(const ActSettings& settings) {
  return [settings](const HitMap& map) { return reconstructHits(map, settings, {}); };
}

/// A picture known at some of its pixels, as a map of intensities.
HitMap knownAt(HitMap map, const Raster<double>& picture, double share, std::uint64_t seed) {
  RandomStream random(seed, 2, RandomPurpose::path);
  for (std::size_t i = 0; i < map.omega.size(); ++i) {
    map.lights[0][i] = random.next() < share ? picture[i] * map.omega[i] : 0.0;
  }
  return map;
}

/// A positive field of degree 8 on a torus of 128 x 96 pixels.
Raster<double> positiveField() {
  Raster<double> field = trigonometricField(128, 96, 8.0, 31);
  const double lowest = least(field);
  for (std::size_t i = 0; i < field.size(); ++i) field[i] += 1.0 - lowest;
  return field;
}

}  // namespace

TEST_CASE("ACT finds a band-limited picture from 15 % of its intensities, whatever the pixels' solid angles") {
  const Raster<double> field = positiveField();
  HitMap torus = emptySky(128, 96, true);
  for (int y = 0; y < 96; ++y) {
    for (int x = 0; x < 128; ++x) torus.omega.at(x, y) = 0.5 + 0.01 * y;
  }
  const Reconstruction result =
      reconstructHits(knownAt(torus, field, 0.15, 32), ActSettings{HitReading::intensities, 8.0, 40}, {});
  CHECK(relativeError(result.lights[0], field) < 1e-9);
}

TEST_CASE("the small grid of ACT's normal equations is exact: a finer polynomial fits as well") {
  // Period 6 px asks for waves the field does not have, on other grids.
  const Raster<double> field = positiveField();
  const HitMap map = knownAt(emptySky(128, 96, true), field, 0.3, 33);
  CHECK(relativeError(reconstructHits(map, ActSettings{HitReading::intensities, 6.0, 60}, {}).lights[0], field) < 1e-6);
}

TEST_CASE("edges that do not touch need not agree in ACT") {
  const HitMap open = emptySky(128, 1), closed = emptySky(128, 1, true);
  Raster<double> ramp(128, 1);
  for (int x = 0; x < 128; ++x) ramp.at(x, 0) = 1.0 + x / 128.0;
  const auto error = [&](const HitMap& sky) {
    return relativeError(
        reconstructHits(knownAt(sky, ramp, 0.3, 34), ActSettings{HitReading::intensities, 12.0, 40}, {}).lights[0],
        ramp);
  };
  CHECK(error(open) < 0.003);
  CHECK(error(closed) > 0.03);
}

TEST_CASE("ACT leaves a constant sky constant up to its border, in both readings") {
  for (const HitReading reading : {HitReading::intensities, HitReading::densities}) {
    for (const double period : {1.0, 5.0, 30.0}) CHECK(errorOfConstantSky(actWith({reading, period, 10})) < 1e-9);
  }
}

TEST_CASE("ACT bears empty maps, single hits, piles and holes") { checkAwkwardMaps(actWith({})); }

TEST_CASE("ACT gives the same bits for any number of threads and takes the same steps for all lights") {
  checkThreadsAndLights(actWith({}));
}

TEST_CASE("ACT on densities keeps the light of a sky full of hits and loses some where they are sparse") {
  const MethodOnMap method = actWith({HitReading::densities, {}, 10});
  for (const std::uint64_t seed : {41U, 42U, 43U}) {
    CHECK(gain(method, poissonHits(emptySky(128, 128), 10.0, seed)) == doctest::Approx(1.0).epsilon(0.002));
    const double sparse = gain(method, poissonHits(emptySky(128, 128), 0.1, seed));
    CHECK(sparse > 0.75);
    CHECK(sparse < 1.0);
  }
}

}  // namespace parhelion
