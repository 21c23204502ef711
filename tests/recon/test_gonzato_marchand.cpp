// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <atomic>

#include <tbb/task_arena.h>

#include "recon/methods.h"
#include "synthetic_hits.h"

namespace parhelion {
namespace {

/// An arc of light on a faint ground.
double arc(double x, double y) {
  const double d = (std::sqrt(x * x + y * y) - 60.0) / 4.0;
  return 0.03 + 1.5 * portable::exp(-d * d);
}

HitMap arcHits(std::uint64_t seed) {
  return poissonMap(
      128, 128, [](int x, int y) { return arc(x - 20.0, y - 30.0); }, seed);
}

/// The paper's kind of signal (its figure 4): a step, then a bump, on a ground of 1.
double stepAndBump(int x) {
  const double d = (x - 380.0) / 25.0;
  return (x >= 100 && x < 260 ? 5.0 : 1.0) + 6.0 * portable::exp(-0.5 * d * d);
}

}  // namespace

TEST_CASE("an even sky is even up to its border, and as bright as its hits") {
  const HitMap square = hitMap(96, 96, [](int, int) { return 1.0; });
  for (const HitMap& map : {square, inDisc(square)}) {
    for (const KernelFlow flow : kFlows) {
      for (const double samples : {9.0, 25.0, 100.0, 1000.0, 2000.0}) {
        const Raster<double> light = picture(map, withSamples(samples, flow));
        CAPTURE(samples);
        CHECK(unevenness(map, light) < 1e-3);
        CHECK(std::abs(energyError(map, light)) < 1e-6);
      }
      // Kernels of more than 24 pixels are balanced on coarser cells.
      CHECK(unevenness(map, picture(map, withSamples(4000.0, flow))) < 0.01);
    }
  }
}

TEST_CASE("an even sky is even where pixels show more and more of it") {
  HitMap map = hitMap(96, 96, [](int, int) { return 1.0; });
  for (int y = 0; y < 96; ++y) {
    for (int x = 0; x < 96; ++x) map.lights[0].at(x, y) = map.omega.at(x, y) = 0.7 + 0.006 * x;
  }
  // Seven pixels a side hold 33 hits everywhere: where sizes change by a pixel, scatter has a seam. At the border a
  // kernel sees less than half of the solid angle's slope, 0.9 % a pixel at most.
  for (const KernelFlow flow : kFlows) CHECK(unevenness(map, picture(map, withSamples(33.0, flow))) < 3 * 0.009 / 2);
}

TEST_CASE("the border does not change what is filtered far from it") {
  const auto density = [](int x, int y) { return x * x + y * y < 400 ? arc(3.0 * x, 3.0 * y) : 1.0; };
  const HitMap small = hitMap(128, 128, [&](int x, int y) { return density(x - 64, y - 64); });
  const HitMap large = hitMap(192, 192, [&](int x, int y) { return density(x - 96, y - 96); });
  for (const KernelFlow flow : kFlows) {
    const Raster<double> cut = picture(small, withSamples(64.0, flow)), whole = picture(large, withSamples(64.0, flow));
    for (int y = 32; y < 96; ++y) {
      for (int x = 32; x < 96; ++x) REQUIRE(cut.at(x, y) == doctest::Approx(whole.at(x + 32, y + 32)).epsilon(1e-12));
    }
  }
}

TEST_CASE("scatter keeps the light of any sky exactly, gather within five per cent") {
  const HitMap square = arcHits(1);
  for (const HitMap& map : {square, inDisc(square)}) {
    for (const std::optional<double> samples :
         {std::optional<double>(), std::optional<double>(16.0), std::optional<double>(40.0)}) {
      for (const double lobes : {1.0, 2.0}) {
        GonzatoMarchandSettings settings = withSamples(samples, KernelFlow::scatter);
        settings.lobes = lobes;
        CHECK(std::abs(energyError(map, picture(map, settings))) < 1e-6);
        settings.flow = KernelFlow::gather;
        CHECK(std::abs(energyError(map, picture(map, settings))) < 0.05);
      }
    }
  }
}

TEST_CASE("all kinds of light go through the same filter, chosen by the first") {
  HitMap map = arcHits(2);
  map.lights.push_back(map.lights[0]);
  for (std::size_t i = 0; i < map.lights[1].size(); ++i) map.lights[1][i] *= -0.25;
  for (const KernelFlow flow : kFlows) {
    for (const int iterations : {0, 2}) {
      const std::vector<Raster<double>> lights = reconstructHits(map, withSamples(40.0, flow, iterations), {}).lights;
      REQUIRE(lights.size() == 2);
      for (std::size_t i = 0; i < lights[0].size(); ++i) REQUIRE(lights[1][i] == -0.25 * lights[0][i]);
    }
  }
}

TEST_CASE("a torus has no border: moved hits give the moved picture") {
  HitMap map = arcHits(3), moved = map;
  for (int y = 0; y < 128; ++y) {
    for (int x = 0; x < 128; ++x) moved.lights[0].at((x + 77) % 128, (y + 50) % 128) = map.hits().at(x, y);
  }
  map.wrapX = map.wrapY = moved.wrapX = moved.wrapY = true;
  for (const KernelFlow flow : kFlows) {
    const Raster<double> a = picture(map, withSamples(60.0, flow)), b = picture(moved, withSamples(60.0, flow));
    for (int y = 0; y < 128; ++y) {
      for (int x = 0; x < 128; ++x) {
        REQUIRE(b.at((x + 77) % 128, (y + 50) % 128) == doctest::Approx(a.at(x, y)).epsilon(1e-12));
      }
    }
  }
}

TEST_CASE("a signal is a picture one pixel high: a step stays a step and a bump a bump") {
  const HitMap signal = hitMap(512, 1, [](int x, int) { return stepAndBump(x); });
  const HitMap upright = hitMap(1, 512, [](int, int y) { return stepAndBump(y); });
  for (const KernelFlow flow : kFlows) {
    const Raster<double> light = picture(signal, withSamples(40.0, flow));
    // Half the interval that holds 40 hits is 20 pixels in the ground and 4 on the step.
    CHECK(columns(light, 120, 240).least == doctest::Approx(5.0).epsilon(1e-6));
    CHECK(columns(light, 120, 240).greatest == doctest::Approx(5.0).epsilon(1e-6));
    CHECK(unevenness(signal, light) > 3.9);
    CHECK(columns(light, 0, 60).greatest == doctest::Approx(1.0).epsilon(1e-3));
    CHECK(columns(light, 0, 60).least == doctest::Approx(1.0).epsilon(1e-3));
    // Light from the foot of the step, where intervals are long, reaches what gets its own share as well.
    CHECK(columns(light, 0, 300).greatest < (flow == KernelFlow::scatter ? 5.6 : 5.001));
    CHECK(columns(light, 0, 512).least > 0.0);
    CHECK(light.at(380, 0) == doctest::Approx(7.0).epsilon(0.02));
    CHECK(std::abs(energyError(signal, light)) < (flow == KernelFlow::scatter ? 1e-6 : 0.05));
    CHECK(rmsDifference(light, picture(upright, withSamples(40.0, flow))) < 1e-6);
  }
}

TEST_CASE("both readings agree where every pixel holds enough hits, and there alone") {
  GonzatoMarchandSettings unit = withSamples(16.0, KernelFlow::gather), paper = unit;
  paper.gain = KernelGain::paper;
  const HitMap bright = poissonMap(
      48, 48, [](int, int) { return 60.0; }, 4);
  CHECK(rmsDifference(picture(bright, unit), picture(bright, paper)) < 1e-6);
  const HitMap faint = poissonMap(
      48, 48, [](int, int) { return 0.1; }, 4);
  CHECK(total(picture(faint, paper)) > 10.0 * total(picture(faint, unit)));
}

TEST_CASE("iterations sharpen what is free of noise and roughen what is not") {
  const auto density = [](int x, int y) { return arc(x - 20.0, y - 30.0); };
  const HitMap clean = hitMap(128, 128, density);
  const HitMap noisy = poissonMap(128, 128, density, 5);
  for (const KernelFlow flow : kFlows) {
    const auto error = [&](const HitMap& map, int iterations) {
      return rmsDifference(picture(map, withSamples(100.0, flow, iterations)), clean.hits());
    };
    CHECK(error(clean, 1) < 0.7 * error(clean, 0));
    CHECK(error(clean, 5) < 0.7 * error(clean, 1));
    CHECK(error(noisy, 20) > 1.2 * error(noisy, 1));
  }
}

TEST_CASE("m grows with the hits, and is told where it was chosen") {
  // The best of halo displays of 512 x 512 pixels with 1e4, 1e5, 1e6 and 1e7 rays, within a quarter.
  CHECK(hitsPerSquare(3590.0) == doctest::Approx(30.0).epsilon(0.25));
  CHECK(hitsPerSquare(35545.0) == doctest::Approx(105.0).epsilon(0.25));
  CHECK(hitsPerSquare(3.5505e5) == doctest::Approx(370.0).epsilon(0.25));
  CHECK(hitsPerSquare(3.5586e6) == doctest::Approx(1450.0).epsilon(0.25));

  const Reconstruction chosen = reconstructHits(arcHits(6), GonzatoMarchandSettings{}, {});
  REQUIRE(chosen.remarks.size() == 1);
  CHECK(chosen.remarks[0].find("squares grow until they hold") == 0);
  CHECK(reconstructHits(arcHits(6), withSamples(20.0, KernelFlow::scatter), {}).remarks.empty());
}

TEST_CASE("pictures have the same bits for any number of threads") {
  const HitMap map = inDisc(arcHits(7));
  for (const KernelFlow flow : kFlows) {
    Raster<double> one, two;
    tbb::task_arena(1).execute([&] { one = picture(map, withSamples({}, flow, 2)); });
    tbb::task_arena(2).execute([&] { two = picture(map, withSamples({}, flow, 2)); });
    CHECK(sameBits(one, two));
  }
}

TEST_CASE("the method can be followed and stopped") {
  std::vector<double> shares;
  std::atomic<bool> stop = false;
  Watch watch;
  watch.onProgress = [&](double share) {
    shares.push_back(share);
    stop = shares.size() == 4;
  };
  watch.stop = &stop;
  CHECK_THROWS_AS(reconstructHits(arcHits(8), withSamples(20.0, KernelFlow::scatter, 5), watch), ReconStopped);
  REQUIRE(shares.size() == 4);
  CHECK(shares.front() == 0.0);
  CHECK(std::ranges::is_sorted(shares));
  CHECK(shares.back() < 1.0);
}

}  // namespace parhelion
