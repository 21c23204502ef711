// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "recon/methods.h"
#include "recon/published/square_sizes.h"
#include "synthetic_hits.h"

// Where the method of Gonzato & Marchand fails in the paper's reading, and must not with unit gain.

namespace parhelion {
namespace {

constexpr int kSide = 128;

GonzatoMarchandSettings toTheLetter(int iterations = 0) {
  GonzatoMarchandSettings settings;
  settings.gain = KernelGain::paper;
  settings.flow = KernelFlow::gather;
  settings.samples = 16.0;
  settings.iterations = iterations;
  return settings;
}

/// Two half planes of whole hits on a lattice, 2 in each pixel and 1 in 50 pixels.
HitMap halfPlanes() {
  return hitMap(320, 160, [](int x, int y) { return x >= 160 ? 2.0 : x % 10 == 3 && y % 5 == 2 ? 1.0 : 0.0; });
}

/// The same as densities without noise.
HitMap step() {
  return hitMap(320, 160, [](int x, int) { return x >= 160 ? 2.0 : 0.02; });
}

/// Bright over faint, away from the step and the border.
double contrast(const Raster<double>& light) { return columns(light, 200, 280).mean / columns(light, 40, 100).mean; }

}  // namespace

TEST_CASE("density: two skies of 2 and 0.02 hits per pixel differ by 100, in the paper's reading by next to nothing") {
  for (const KernelFlow flow : kFlows) {
    CHECK(contrast(picture(halfPlanes(), withSamples({}, flow))) == doctest::Approx(100.0).epsilon(0.05));
    CHECK(contrast(picture(halfPlanes(), withSamples(40.0, flow))) == doctest::Approx(100.0).epsilon(0.05));
  }
  // 16 hits of the bright sky fit into three pixels a side, whose kernel is the identity: 2. In the faint one 16 hits
  // make about as much.
  const double lost = contrast(picture(halfPlanes(), toTheLetter()));
  CHECK(lost > 0.5);
  CHECK(lost < 10.0);
}

TEST_CASE("divergence: unnormalised kernels over 16 hits make the residual grow, which is stopped and told") {
  const HitMap map = poissonMap(
      kSide, kSide, [](int, int) { return 0.5; }, 1);
  const Reconstruction stopped = reconstructHits(map, toTheLetter(10), {});
  REQUIRE(stopped.remarks.size() == 1);
  CHECK(stopped.remarks[0].find("iteration 1 raises the residual from") == 0);
  CHECK(sameBits(stopped.lights[0], picture(map, toTheLetter())));
  for (const KernelFlow flow : kFlows) {
    CHECK(reconstructHits(map, withSamples(16.0, flow, 10), {}).remarks.empty());
  }
}

TEST_CASE("inflation: iterations over all pixels keep the light of an even sky") {
  const HitMap map = poissonMap(
      kSide, kSide, [](int, int) { return 0.1; }, 2);
  for (const KernelFlow flow : kFlows) {
    CHECK(std::abs(energyError(map, picture(map, withSamples({}, flow, 10)))) < 0.02);
  }
}

TEST_CASE("hole: no light is invented in a hole of the hit map, nor a ring around it") {
  const HitMap map =
      hitMap(kSide, kSide, [](int x, int y) { return std::abs(x - 64) < 16 && std::abs(y - 64) < 16 ? 0.0 : 1.0; });
  for (const KernelFlow flow : kFlows) {
    const ColumnRange all = columns(picture(map, withSamples({}, flow)), 0, kSide);
    CHECK(all.least >= 0.0);
    CHECK(all.greatest < 2.0);
  }
}

TEST_CASE("ringing: a step of 1 to 100 has no negative side and overshoots by less than a tenth") {
  for (const KernelFlow flow : kFlows) {
    for (const std::optional<double> samples : {std::optional<double>(), std::optional<double>(64.0)}) {
      const ColumnRange all = columns(picture(step(), withSamples(samples, flow)), 0, 320);
      CHECK(all.least >= 0.0);
      CHECK(all.greatest < 2.2);
    }
  }
}

TEST_CASE("caustic: the sharp edge of an arc leaks little, and the less the more hits there are") {
  const auto edge = [](double scale) {
    // Means over pixels of 1 / sqrt(x) right of the middle.
    return hitMap(256, 64, [&](int x, int) {
      return x < 128 ? 0.0 : 2.0 * scale * (std::sqrt(x - 127.0) - std::sqrt(x - 128.0));
    });
  };
  for (const KernelFlow flow : kFlows) {
    const auto leak = [&](double scale) {
      const Raster<double> light = picture(edge(scale), withSamples({}, flow));
      return light.at(122, 32) / columns(light, 0, 256).greatest;
    };
    CHECK(leak(2.0) < 0.05);
    CHECK(leak(200.0) <= leak(2.0));
    CHECK(leak(0.02) > leak(2.0));
  }
}

TEST_CASE("one hit is spread and kept, wherever it falls") {
  const HitMap square = hitMap(kSide, kSide, [](int, int) { return 0.0; });
  for (HitMap map : {square, inDisc(square)}) {
    for (const int x : {64, 20, 0}) {
      map.lights[0] = Raster<double>(kSide, kSide);
      map.lights[0].at(x, 64) = map.omega.at(x, 64);
      const Raster<double> light = picture(map, {});
      CHECK(std::abs(energyError(map, light)) < 1e-6);
      CHECK(columns(light, 0, kSide).least >= 0.0);
      CHECK(columns(light, 0, kSide).greatest < 0.01);
    }
  }
}

TEST_CASE("a pile of hits in one pixel stays there, without a ring") {
  HitMap map = hitMap(kSide, kSide, [](int, int) { return 0.0; });
  map.lights[0].at(50, 70) = 5000.0;
  for (const KernelFlow flow : kFlows) {
    const Raster<double> light = picture(map, withSamples({}, flow));
    CHECK(light.at(50, 70) == 5000.0);
    CHECK(total(light) == 5000.0);
  }
}

TEST_CASE("a pile of 1e8 hits is exact and leaves the sizes elsewhere alone") {
  const HitMap plain = poissonMap(
      kSide, kSide, [](int, int) { return 0.3; }, 3);
  HitMap piled = plain;
  piled.lights[0].at(64, 64) = 1e8;
  for (const KernelFlow flow : kFlows) {
    for (const std::optional<double> samples : {std::optional<double>(), std::optional<double>(40.0)}) {
      const Raster<double> light = picture(piled, withSamples(samples, flow));
      const Raster<double> without = picture(plain, withSamples(samples, flow));
      CHECK(light.at(64, 64) == doctest::Approx(1e8).epsilon(1e-6));
      CHECK(columns(light, 0, 64).greatest < 1.5 * columns(without, 0, kSide).greatest + 4.0);
      CHECK(columns(light, 0, 32).mean == doctest::Approx(columns(without, 0, 32).mean).epsilon(0.01));
    }
  }
  const Raster<int> sizes = squareSizes(piled, SkyExtent(piled), 40.0);
  const Raster<int> before = squareSizes(plain, SkyExtent(plain), 40.0);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const int away = std::max(std::abs(x - 64), std::abs(y - 64));
      REQUIRE(sizes.at(x, y) == std::min(before.at(x, y), away));
    }
  }
}

TEST_CASE("no hits, no sky and hits outside the sky give black") {
  HitMap map = hitMap(32, 32, [](int, int) { return 0.0; });
  const auto black = [](const Raster<double>& light) { return light.size() == 1024 && total(light) == 0.0; };
  for (const KernelFlow flow : kFlows) CHECK(black(picture(map, withSamples({}, flow))));
  map.omega = Raster<double>(32, 32);
  for (const KernelFlow flow : kFlows) CHECK(black(picture(map, withSamples({}, flow))));
  map.lights[0].at(5, 5) = 7.0;
  for (const KernelFlow flow : kFlows) CHECK(black(picture(map, withSamples({}, flow, 2))));
}

}  // namespace parhelion
