// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <thread>

#include "sky/tally.h"

namespace parhelion {
namespace {

TallyInfo info(int width, int height) {
  TallyInfo i;
  i.camera.width = width;
  i.camera.height = height;
  i.white = {0.97, 1.0, 1.05};
  i.scene = "[sun]";
  return i;
}

TallyInfo traced(std::uint64_t first, std::uint64_t count) {
  TallyInfo i = info(1, 1);
  i.rays = {{first, count}};
  i.intercepted = LightTotal(LightTotal::Units{static_cast<std::int64_t>(count)} << 28);
  return i;
}

}  // namespace

TEST_CASE("fixed point rounds to nearest on both sides of zero") {
  CHECK(toFixed(1.0) == (std::int64_t{1} << 28));
  CHECK(toFixed(1.4 / kWeightScale) == 1);
  CHECK(toFixed(1.6 / kWeightScale) == 2);
  CHECK(toFixed(-1.6 / kWeightScale) == -2);
  CHECK(toFixed(-0.0) == 0);
  CHECK(fromFixed(toFixed(0.123456789)) == doctest::Approx(0.123456789).epsilon(1e-8));
}

TEST_CASE("the total of many amounts is that of each added by itself, beyond 64 bits and of either sign") {
  constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max(), kLeast = -kMost - 1;
  ManyAmounts many;
  LightTotal one;
  for (const std::int64_t amount : {std::int64_t{7}, kMost, kMost, std::int64_t{1}, kLeast, kLeast, kLeast, kLeast,
                                    std::int64_t{-3}, kMost, kMost, kMost}) {
    many.add(amount);
    one.addUnits(amount);
    CHECK(many.total() == one);
  }
}

TEST_CASE("1e9 unit weights in one pixel are exact, where a float stalls at 2^24") {
  Tally sum(info(1, 1)), part(info(1, 1));
  for (int i = 0; i < 100'000; ++i) part.add(0, {0.97, 1.0, 1.05}, i % 2 == 0);
  for (std::uint64_t i = 0; i < 10'000; ++i) {
    part.info.rays = {{i * 100'000, 100'000}};
    sum.merge(part);
  }
  CHECK(sum.luminance(0) == 1e9);
  CHECK(sum.firstHalf(0) == 5e8);
  CHECK(sum.squares(0) == 1e9);
  CHECK(sum.hits(0) == 1'000'000'000);
  CHECK(sum.xyz(0).x == doctest::Approx(0.97e9).epsilon(1e-15));
  CHECK(sum.xyz(0).z == doctest::Approx(1.05e9).epsilon(1e-15));
  CHECK(sum.info.rays == std::vector<RayRange>{{0, 1'000'000'000}});
}

TEST_CASE("the light of 3e10 rays in one pixel does not overflow, whatever the white") {
  TallyInfo blue = info(1, 1);
  blue.white = {8.8, 1.0, 46.6};  // of a spectral line at 450 nm
  Tally tally(blue);
  tally.add(0, blue.white, false);
  for (const int slot : {Tally::kY, Tally::kX, Tally::kZ}) {
    CHECK(static_cast<double>(tally.raw(0, slot)) * 3e10 < 0x1p63);
  }
  CHECK(toFixed(4.5, kSquareScale) * 30'000'000'000 > 0);  // signed overflow would be caught by the sanitizer
}

TEST_CASE("a tally that cannot hold the light says so, whichever way the light comes") {
  const auto filled = [](int slot, std::int64_t sum) {
    TallyInfo wide = info(3, 1);
    wide.rays = {{0, 10}};
    Tally tally(wide);
    for (int pixel = 0; pixel < 3; ++pixel) tally.setRaw(pixel, slot, sum);
    return tally;
  };
  constexpr std::int64_t kFull = std::numeric_limits<std::int64_t>::max();
  Tally empty(info(1, 1));
  CHECK_THROWS_AS(empty.addExclusively(0, Vec3(1e12), false), std::overflow_error);
  CHECK_THROWS_AS(empty.add(0, Vec3(std::nan("")), false), std::overflow_error);
  for (const int slot : {Tally::kY, Tally::kFirstHalf, Tally::kSquares, Tally::kX, Tally::kZ}) {
    CAPTURE(slot);
    CHECK_THROWS_AS(filled(slot, kFull).addExclusively(1, Vec3(1.0), true), std::overflow_error);
    CHECK_THROWS_AS(filled(slot, kFull).add(1, Vec3(1.0), true), std::overflow_error);
    CHECK_THROWS_AS(filled(slot, kFull / 2 + 1).addMirrorImage(), std::overflow_error);
    Tally other = filled(slot, kFull / 2 + 1);
    other.info.rays = {{10, 10}};
    CHECK_THROWS_AS(filled(slot, kFull / 2 + 1).merge(other), std::overflow_error);
  }
  // In the middle column two deposits become one of twice the light and four times its square.
  Tally middle = filled(Tally::kSquares, kFull / 4);
  CHECK_NOTHROW(middle.addMirrorImage());
  CHECK(middle.raw(1, Tally::kSquares) == kFull / 4 * 4);
  CHECK_THROWS_AS(filled(Tally::kSquares, kFull / 4 + 1).addMirrorImage(), std::overflow_error);
}

TEST_CASE("the totals hold the light of 1e15 rays, to the unit") {
  constexpr std::uint64_t kRays = 1'000'000'000'000;
  Tally sum(traced(0, kRays));
  for (std::uint64_t i = 1; i < 1000; ++i) sum.merge(Tally(traced(i * kRays, kRays)));
  CHECK(sum.info.rayCount() == 1'000'000'000'000'000);
  CHECK(sum.info.interceptedLight() == 1e15);
  CHECK(sum.info.intercepted.units() == LightTotal::Units{1'000'000'000'000'000} << 28);
}

TEST_CASE("eight threads that add in random order give the same bits as one") {
  struct Deposit {
    int pixel;
    Vec3 xyz;
    bool firstHalf;
  };
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Deposit> deposits(400'000);
  for (Deposit& d : deposits) {
    d = {static_cast<int>(random() % 12), {unit(random), unit(random), unit(random)}, random() % 2 == 0};
  }
  for (const int colours : {1, 3}) {
    Tally serial(info(4, 3), colours), parallel(info(4, 3), colours);
    for (const Deposit& d : deposits) serial.add(d.pixel, d.xyz, d.firstHalf);
    std::shuffle(deposits.begin(), deposits.end(), random);
    std::vector<std::jthread> threads;
    for (std::size_t t = 0; t < 8; ++t) {
      threads.emplace_back([&, t] {
        for (std::size_t i = t; i < deposits.size(); i += 8) {
          parallel.add(deposits[i].pixel, deposits[i].xyz, deposits[i].firstHalf);
        }
      });
    }
    threads.clear();
    CHECK(serial == parallel);
    parallel.add(3, {1e-8, 1e-8, 1e-8}, true);
    CHECK_FALSE(serial == parallel);
  }
}

TEST_CASE("shards merged in any order give the same bits and the whole range of rays") {
  std::vector<Tally> shards;
  for (std::uint64_t s = 0; s < 6; ++s) {
    shards.emplace_back(traced(s * 10, 10));
    shards.back().add(0, {0.1 * static_cast<double>(s), 1.0 / 3.0, 0.7}, s % 2 == 0);
  }
  const auto merged = [&](std::vector<std::size_t> order) {
    Tally sum = shards[order[0]];
    for (std::size_t i = 1; i < order.size(); ++i) sum.merge(shards[order[i]]);
    return sum;
  };
  const Tally forward = merged({0, 1, 2, 3, 4, 5});
  CHECK(forward == merged({4, 1, 5, 0, 3, 2}));
  CHECK(forward.info.rays == std::vector<RayRange>{{0, 60}});
  CHECK(forward.info.rayCount() == 60);
  CHECK(forward.info.interceptedLight() == 60.0);
  CHECK(merged({0, 2}).info.rays == std::vector<RayRange>{{0, 10}, {20, 10}});  // a gap is told
}

TEST_CASE("tallies that overlap or belong to different pictures do not merge, and stay as they were") {
  Tally sum(traced(0, 10));
  const Tally before = sum;
  const auto refused = [&](const Tally& other) {
    CHECK_THROWS_AS(sum.merge(other), std::invalid_argument);
    CHECK(sum == before);
  };
  refused(Tally(traced(9, 5)));
  refused(Tally(traced(0, 10)));
  refused(Tally(traced(10, 10), 1));
  TallyInfo other = traced(10, 10);
  other.seed = 2;
  refused(Tally(other));
  other = traced(10, 10);
  other.sceneHash = 1;
  refused(Tally(other));
  other = traced(10, 10);
  other.numerics = 1;
  refused(Tally(other));
  other = traced(10, 10);
  other.symmetry = TallySymmetry::mirror;
  refused(Tally(other));
  other = traced(10, 10);
  other.camera.roll = 0.1;
  refused(Tally(other));
}

TEST_CASE("the standard error of a pixel is that of a sum of rays, most of which miss it") {
  // 10000 rays, of which each hits with probability 1/4 and brings light 1 or 3 in turn: the variance of the sum is
  // n <w^2> - (n <w>)^2 / n with <w^2> = 5/4, <w> = 1/2.
  Tally tally(traced(0, 10'000));
  for (int i = 0; i < 2'500; ++i) tally.add(0, Vec3(i % 2 == 0 ? 1.0 : 3.0), false);
  CHECK(tally.luminanceError(0) == doctest::Approx(std::sqrt(10'000 * (1.25 - 0.25))).epsilon(1e-12));
  CHECK(Tally(info(1, 1)).luminanceError(0) == 0.0);
}

TEST_CASE("with one colour only the luminance is kept, shown in the sun's white") {
  Tally tally(info(2, 2), 1);
  tally.add(3, {5.0, 0.5, 7.0}, true);
  CHECK(tally.luminance(3) == 0.5);
  CHECK(tally.firstHalf(3) == 0.5);
  CHECK(tally.xyz(3).x == doctest::Approx(0.5 * 0.97));
  CHECK(tally.hits(2) == 0);
}

TEST_CASE("a tally refuses a camera, colours or a white that make no sense") {
  CHECK_THROWS_AS(Tally(info(0, 1)), std::invalid_argument);
  CHECK_THROWS_AS(Tally(info(1, 1), 2), std::invalid_argument);
  TallyInfo i = info(1, 1);
  i.white.z = std::nan("");
  CHECK_THROWS_AS(Tally{i}, std::invalid_argument);
  i.white = {1.0, 2.0, 1.0};
  CHECK_THROWS_AS(Tally{i}, std::invalid_argument);
}

}  // namespace parhelion
