// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "recon/published/sinc_bank.h"
#include "recon/published/sinc_kernel.h"
#include "recon/published/square_sizes.h"
#include "synthetic_hits.h"

namespace parhelion {
namespace {

double weight(const SincKernel& kernel, int x, int y) {
  if (std::abs(y) > kernel.reachY()) return 0.0;
  const SincKernel::Row row = kernel.row(y);
  return std::abs(x) > row.reach ? 0.0 : static_cast<double>(row.weights[x]);
}

double sum(const SincKernel& kernel) {
  double total = 0.0;
  for (int y = -kernel.reachY(); y <= kernel.reachY(); ++y) {
    for (int x = -kernel.reachX(); x <= kernel.reachX(); ++x) total += weight(kernel, x, y);
  }
  return total;
}

SincKernel squareKernel(double radius, double lobes, KernelGain gain) { return {radius, lobes, gain, false, false}; }

/// Hits in the square around a pixel of a torus, counted one by one.
double hitsAround(const HitMap& map, int x, int y, int radius) {
  double hits = 0.0;
  for (int j = y - radius; j <= y + radius; ++j) {
    for (int i = x - radius; i <= x + radius; ++i) {
      hits += map.hits().at((i + map.width()) % map.width(), (j + map.height()) % map.height());
    }
  }
  return hits;
}

HitMap torus(int side, std::uint64_t seed) {
  HitMap map = poissonMap(
      side, side, [&](int x, int) { return x < side / 2 ? 0.05 : 0.6; }, seed);
  map.wrapX = map.wrapY = true;
  return map;
}

}  // namespace

TEST_CASE("the windowed sinc has its zeros at multiples of Ts and ends at k Ts") {
  CHECK(windowedSinc(0.0, 5.0, 2.0) == 1.0);
  CHECK(std::abs(windowedSinc(5.0, 5.0, 2.0)) < 1e-15);
  CHECK(windowedSinc(7.0, 5.0, 2.0) < 0.0);
  CHECK(windowedSinc(10.0, 5.0, 2.0) == 0.0);
  CHECK(windowedSinc(11.0, 5.0, 2.0) == 0.0);
  CHECK(windowedSinc(2.5, 5.0, 1.0) == doctest::Approx(0.5 * 2.0 / kPi));  // Hann 1/2, sinc 2/pi
}

TEST_CASE("kernels of one and of three pixels are the identity") {
  for (const KernelGain gain : {KernelGain::unit, KernelGain::paper}) {
    for (const double radius : {0.0, 1.0}) {
      const SincKernel kernel = squareKernel(radius, 1.0, gain);
      CHECK(kernel.reachX() == 0);
      CHECK(kernel.reachY() == 0);
      CHECK(kernel.row(0).weights[0] == 1.0F);
    }
  }
}

TEST_CASE("kernels are round, symmetric, and without negative weights for k = 1 alone") {
  for (const double lobes : {1.0, 2.0}) {
    const SincKernel kernel = squareKernel(12.0, lobes, KernelGain::paper);
    double least = 1.0;
    for (int y = -12; y <= 12; ++y) {
      for (int x = -12; x <= 12; ++x) {
        const double t = std::sqrt(x * x + y * y);
        REQUIRE(weight(kernel, x, y) == doctest::Approx(windowedSinc(t, 12.0 / lobes, lobes)).epsilon(1e-6));
        least = std::min(least, weight(kernel, x, y));
      }
    }
    CHECK(weight(kernel, 9, 9) == 0.0);  // in the corner, where Hann's formula rises again
    CHECK((least < 0.0) == (lobes == 2.0));
  }
}

TEST_CASE("unit gain adds up to 1 and the paper's gain grows as the square of Ts, in signals as Ts") {
  for (const bool signal : {false, true}) {
    CHECK(sum(SincKernel(17.0, 1.0, KernelGain::unit, false, signal)) == doctest::Approx(1.0).epsilon(1e-6));
    const double ratio = sum(SincKernel(32.0, 1.0, KernelGain::paper, false, signal)) /
                         sum(SincKernel(16.0, 1.0, KernelGain::paper, false, signal));
    CHECK(ratio == doctest::Approx(signal ? 2.0 : 4.0).epsilon(0.01));
  }
}

TEST_CASE("the bank holds every radius up to 32 pixels, and beyond one within a sixteenth, in little memory") {
  Raster<int> radii(512, 1);
  for (int i = 0; i < 512; ++i) radii[static_cast<std::size_t>(i)] = std::min(i, 255);
  const SincBank bank(radii, {512, 512}, 1.0, KernelGain::unit);
  for (int radius = 0; radius < 256; ++radius) {
    const int rounded = SincBank::rounded(radius);
    CHECK(bank.at(radius).reachX() == std::max(rounded - 1, 0));
    CHECK(rounded <= radius);
    CHECK((radius <= 32 ? rounded == radius : rounded > radius * 15 / 16));
  }
  CHECK(bank.bytes() < 6'000'000);
}

TEST_CASE("squares are the smallest that hold m hits, across wrapped edges") {
  const HitMap map = torus(48, 3);
  const Raster<int> radii = squareSizes(map, SkyExtent(map), 12.0);
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 48; ++x) {
      const int radius = radii.at(x, y);
      REQUIRE(hitsAround(map, x, y, radius) >= 12.0);
      if (radius > 0) REQUIRE(hitsAround(map, x, y, radius - 1) < 12.0);
    }
  }
}

TEST_CASE("squares of an even sky do not grow toward its border, and never beyond the picture") {
  const HitMap square = hitMap(64, 64, [](int, int) { return 1.0; });
  for (const HitMap& map : {square, inDisc(square)}) {
    const Raster<int> radii = squareSizes(map, SkyExtent(map), 49.0);
    for (std::size_t i = 0; i < radii.size(); ++i) REQUIRE(radii[i] == (map.omega[i] > 0.0 ? 3 : 0));
    const Raster<int> largest = squareSizes(map, SkyExtent(map), 1e9);
    CHECK(largest.at(32, 32) == 31);
  }
}

}  // namespace parhelion
