// SPDX-License-Identifier: Apache-2.0
#include "sky/radial_sky.h"

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include <doctest/doctest.h>

#include "sky/camera.h"
#include "sky/radial_skies.h"
#include "statistics.h"

namespace parhelion {
namespace {

/// A sky of `hits` hits of random light between 5 and 60 degrees, a quarter of them in the first half.
RadialSky randomSky(const TallyInfo& i, int colours, int hits, unsigned seed, bool equal = false) {
  RadialSky sky(i, kSun, colours);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int k = 0; k < hits; ++k) {
    const double angle = radians(5.0 + 55.0 * unit(random)), y = equal ? 0.5 : unit(random);
    sky.add(sky.binAt(atAngle(angle)), Vec3(0.9 * y, y, 1.2 * y), k % 4 == 0);
  }
  return sky;
}

}  // namespace

TEST_CASE("a ring's place grows as the chord from the centre, and from the antipode beyond 90 degrees") {
  const RadialSky sky(info(Projection::fisheyeEqualArea, 180, 300, 300, 90), kSun);
  const double perChord = sky.bins() / (2.0 * std::sqrt(2.0));
  CHECK(sky.bins() % 2 == 0);
  for (const double angle : {0.0, 1e-9, 1e-6, 1e-3, 0.3, 1.2}) {
    CAPTURE(angle);
    const double steps = 2.0 * std::sin(0.5 * angle) * perChord;
    // Coordinates of unit vectors are off by 1e-16.
    CHECK(std::abs(sky.place(atAngle(angle)) - steps) < 1e-12);
    CHECK(std::abs(sky.place(-atAngle(angle)) - (sky.bins() - steps)) < 1e-12);
  }
  CHECK(sky.binAt(kSun) == 0);
  CHECK(sky.binAt(-kSun) == sky.bins() - 1);
  double total = 0.0;
  for (int bin = 0; bin < sky.bins(); ++bin) total += sky.solidAngle(bin);
  CHECK(total == doctest::Approx(4.0 * kPi).epsilon(1e-12));
  const double cap = 2.0 * kPi * (1.0 - std::cos(2.0 * std::asin(0.5 * 7.0 / perChord)));
  double inner = 0.0;
  for (int bin = 0; bin < 7; ++bin) inner += sky.solidAngle(bin);
  CHECK(inner == doctest::Approx(cap).epsilon(1e-9));
}

TEST_CASE("rings are at most a quarter of the smallest pixel") {
  const TallyInfo wide = info(Projection::rectilinear, 120, 300, 300, 20);
  const Camera camera(wide.camera);
  const double corner = angleBetween(*camera.toSky({0.0, 0.0}), *camera.toSky({std::sqrt(0.5), std::sqrt(0.5)}));
  CHECK(2.0 * std::sqrt(2.0) / RadialSky(wide, kSun).bins() <= 0.25 * corner);
  CHECK(RadialSky(info(Projection::rectilinear, 0.5, 300, 300, 20), kSun).bins() == 1 << 16);
}

TEST_CASE("an even radial sky gives every pixel of hemispheres light by its solid angle, up to the rims") {
  for (const Projection projection :
       {Projection::dualFisheyeEqualArea, Projection::dualFisheyeEquidistant, Projection::dualFisheyeStereographic,
        Projection::dualFisheyeOrthographic, Projection::globe}) {
    CAPTURE(std::string(nameOf(projection)));
    const TallyInfo i = info(projection, 180, projection == Projection::globe ? 60 : 120, 60, 12);
    checkEvenRadialSky(i);
  }
}

TEST_CASE("a ring about the sun is in both discs of a dual fisheye where each shows it") {
  const TallyInfo i = info(Projection::dualFisheyeEqualArea, 180, 120, 60, 12);
  RadialSky sky(i, kSun, 1);
  sky.add(sky.binAt(atAngle(radians(85.0))), Vec3(1.0), false);
  const Tally tally = spread(sky, i);
  const Camera camera(i.camera);
  double left = 0.0, right = 0.0;
  for (int p = 0; p < tally.pixels(); ++p) {
    if (tally.luminance(p) == 0.0) continue;
    (p % 120 < 60 ? left : right) += tally.luminance(p);
    if (const auto toSky = camera.toSky({p % 120 + 0.5, p / 120 + 0.5}))
      CHECK(std::abs(angleBetween(*toSky, kSun) - radians(85.0)) < radians(6.0));
  }
  CHECK(left + right == doctest::Approx(1.0).epsilon(3e-3));  // one ring across pixels of hundreds
  CHECK(left > 0.1);
  CHECK(right > 0.1);
}

TEST_CASE("the halves of a radial sky add up, and merged skies are the same to the bit as one") {
  const TallyInfo i = info(Projection::fisheyeEqualArea, 180, 64, 64, 90);
  RadialSky first(i, kSun), second(i, kSun), both(i, kSun);
  for (int k = 0; k < 20'000; ++k) {
    const int bin = (k * 37) % first.bins();
    const Vec3 xyz{0.3, 0.1 + 1e-5 * k, 0.7};
    (k % 3 == 0 ? first : second).add(bin, xyz, k % 3 == 0);
    both.add(bin, xyz, k % 3 == 0);
  }
  const Tally a = spread(first, i, 3), b = spread(second, i, 3), whole = spread(both, i, 3);
  first.merge(second);
  CHECK(spread(first, i, 3) == whole);
  for (int p = 0; p < whole.pixels(); ++p) {
    CHECK(whole.raw(p, Tally::kFirstHalf) == a.raw(p, Tally::kY));
    CHECK(b.firstHalf(p) == 0.0);
    for (const int slot : {Tally::kY, Tally::kSquares, Tally::kX, Tally::kZ})
      CHECK(std::abs(whole.raw(p, slot) - a.raw(p, slot) - b.raw(p, slot)) <= 1);  // each is rounded by itself
  }
  CHECK_THROWS_AS(first.merge(RadialSky(i, -kSun)), std::invalid_argument);
  CHECK_THROWS_AS(first.merge(RadialSky(i, kSun, 1)), std::invalid_argument);
  Tally grey(i, 1);
  CHECK_THROWS_AS(first.spreadOver(grey), std::invalid_argument);
}

TEST_CASE("the colours of a radial sky arrive in the picture") {
  const TallyInfo i = info(Projection::fisheyeEqualArea, 180, 64, 64, 90);
  const Tally tally = spread(randomSky(i, 3, 20'000, 8), i, 3);
  int lit = 0;
  for (int p = 0; p < tally.pixels(); ++p) {
    const Vec3 xyz = tally.xyz(p);
    if (xyz.y < 0.01) continue;
    CHECK(xyz.x / xyz.y == doctest::Approx(0.9).epsilon(1e-6));
    CHECK(xyz.z / xyz.y == doctest::Approx(1.2).epsilon(1e-6));
    ++lit;
  }
  CHECK(lit > 500);
}

TEST_CASE("the error a pixel states is the scatter of its light over many skies") {
  TallyInfo i = info(Projection::fisheyeEqualArea, 180, 32, 32, 90);
  constexpr int kSkies = 400, kHits = 8000;
  i.rays = {{0, kHits}};
  const int pixels = i.camera.width * i.camera.height;
  std::vector<SampleMean> light(static_cast<std::size_t>(pixels)), variance(light), half(light);
  for (unsigned seed = 0; seed < kSkies; ++seed) {
    const Tally tally = spread(randomSky(i, 1, kHits, seed), i);
    for (int p = 0; p < pixels; ++p) {
      light[static_cast<std::size_t>(p)].add(tally.luminance(p));
      half[static_cast<std::size_t>(p)].add(tally.firstHalf(p));
      variance[static_cast<std::size_t>(p)].add(tally.luminanceError(p) * tally.luminanceError(p));
    }
  }
  int compared = 0;
  double mostSigmas = 0.0;
  for (std::size_t p = 0; p < light.size(); ++p) {
    // 20 hits and more a pixel: nearly normal, so that a variance has the relative error sqrt(2 / kSkies). Less light
    // leaves the rounding of the squares to be seen.
    if (light[p].mean() < 0.05) continue;
    const double ratio = light[p].variance() / variance[p].mean();
    mostSigmas = std::max(mostSigmas, std::abs(ratio - 1.0) / std::sqrt(2.1 / kSkies));
    CHECK(std::abs(half[p].mean() / light[p].mean() - 0.25) < kSigmas * half[p].standardError() / light[p].mean());
    ++compared;
  }
  CHECK(compared > 200);
  CHECK(mostSigmas < kSigmas);
}

TEST_CASE("a pixel's hits are as many as equal hits with its relative error") {
  TallyInfo i = info(Projection::fisheyeEqualArea, 180, 32, 32, 90);
  i.rays = {{0, 1'000'000'000}};
  const Tally tally = spread(randomSky(i, 1, 200'000, 3, true), i);
  int compared = 0;
  for (int p = 0; p < tally.pixels(); ++p) {
    if (tally.luminance(p) < 1.0) continue;
    const double relative = tally.luminanceError(p) / tally.luminance(p);
    // Hits are whole numbers, squares are rounded too.
    CHECK(1.0 / (relative * relative) == doctest::Approx(static_cast<double>(tally.hits(p))).epsilon(1e-3));
    CHECK(tally.hits(p) > 100);
    ++compared;
  }
  CHECK(compared > 200);
}

}  // namespace parhelion
