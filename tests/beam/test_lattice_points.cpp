// SPDX-License-Identifier: Apache-2.0
#include "beam/lattice_points.h"

#include <cmath>
#include <vector>

#include <doctest/doctest.h>

using namespace parhelion;

namespace {

constexpr std::array<double, LatticePoints::kColours> kAt{0.06, 0.19, 0.31, 0.44, 0.56, 0.69, 0.81, 0.94};

/// Light that is twice as dense at the second index, and grows along one side.
const SpreadLight kLight{{{10.0, 14.0, 13.0, 17.0}, {1.0, 2.0, 1.0, 2.0}},
                         {{12.0, 16.0, 15.0, 19.0}, {2.0, 4.0, 2.0, 4.0}}};

}  // namespace

TEST_CASE(
    "points of a lattice have all light, each colour as much of it as its place says, and the mean of its places") {
  constexpr int kCount = 4000;
  constexpr double kShare = 0.25;
  LatticePoints points(kLight, kShare, kCount, kAt, 5);
  std::array<double, LatticePoints::kColours> byColour{};
  double place = 0.0, light = 0.0;
  int made = 0;
  while (const int count = points.next())
    for (int k = 0; k < count; ++k, ++made) {
      CHECK(points.place(k) >= 10.0);
      CHECK(points.place(k) <= 19.0);
      byColour[points.colourOf(k)] += points.light(k);
      place += points.place(k);
      light += points.light(k);
    }
  CHECK(made == kCount);
  // Density is 1.5 (1 + u) on average.
  CHECK(light == doctest::Approx(kShare * 1.5 * 1.5).epsilon(1e-3));
  CHECK(place / kCount == doctest::Approx(14.5).epsilon(1e-3));
  for (std::size_t j = 0; j < byColour.size(); ++j)
    CHECK(byColour[j] == doctest::Approx(kShare * 1.5 * (1.0 + kAt[j]) / 8.0).epsilon(3e-3));
}

TEST_CASE("points of a lattice are nowhere far from a grid's") {
  // The places are sums of three even numbers, from 0 to 4, 3 and 2 rings: the share below a place is known.
  constexpr int kCount = 64;
  SpreadLight even = kLight;
  for (double* density : {even.from.density, even.to.density})
    for (int k = 0; k < 4; ++k) density[k] = 1.0;
  const auto cube = [](double x) { return x > 0.0 ? x * x * x : 0.0; };
  const auto below = [&](double x) {
    double sum = 0.0;
    for (int k = 0; k < 8; ++k) {
      const double corner = (k & 1 ? 4.0 : 0.0) + (k & 2 ? 3.0 : 0.0) + (k & 4 ? 2.0 : 0.0);
      sum += (__builtin_popcount(static_cast<unsigned>(k)) % 2 ? -1.0 : 1.0) * cube(x - corner);
    }
    return sum / (6.0 * 4.0 * 3.0 * 2.0);
  };
  double worst = 0.0;
  for (unsigned start = 0; start < 40; ++start) {
    LatticePoints points(even, 1.0, kCount, kAt, start);
    REQUIRE(points.next() == kCount);
    for (double x = 1.0; x < 9.0; x += 1.0) {
      double share = 0.0;
      for (int k = 0; k < kCount; ++k) share += points.place(k) - 10.0 < x ? points.light(k) : 0.0;
      worst = std::max(worst, std::abs(share - below(x)));
    }
  }
  // Points at random would have a standard error of 0.06.
  CHECK(worst < 0.04);
}
