// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "recon/adaptive/structure_tensor.h"
#include "synthetic_tally.h"

namespace parhelion {
namespace {

constexpr int kSide = 192;

/// Mean aspect ratio of kernels in a picture of Poisson hits, and the mean cosine of twice the long axis' direction.
struct Shapes {
  double aspect = 0.0, direction = 0.0;
};

template <class Density>
Shapes meanShape(const Density& density, double hits) {
  const Tally tally = poissonTally(fullSky(kSide), density, 11);
  const SkyPyramid sky(kSide, kSide, Camera(tally.info.camera).solidAngles());
  Raster<Light<1>> light(kSide, kSide);
  Raster<KernelSite> sites(kSide, kSide);
  for (std::size_t i = 0; i < light.size(); ++i) {
    light[i] = {static_cast<float>(tally.luminance(static_cast<int>(i)))};
    sites[i].density = static_cast<float>(density(static_cast<int>(i) % kSide, static_cast<int>(i) / kSide));
  }
  const Raster<Light<1>> pilot = scatter<1>(sky, KernelField(sky, sites), light, hits);
  const Raster<KernelShape> shapes = kernelShapes(sky, pilot, hits);
  Shapes mean;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    mean.aspect += static_cast<double>(shapes[i].aspect()) / static_cast<double>(shapes.size());
    mean.direction += static_cast<double>(shapes[i].p) / static_cast<double>(shapes.size());
  }
  return mean;
}

}  // namespace

TEST_CASE("noise does not look like arcs, arcs do") {
  for (const double density : {0.1, 1.0, 10.0}) {
    const Shapes flat = meanShape([&](int, int) { return density; }, 64.0);
    CHECK(flat.aspect < 1.5);
    CHECK(std::abs(flat.direction) < 0.2);
  }
  const Shapes stripes = meanShape([](int x, int) { return 1.0 + 0.9 * std::sin(0.2 * x); }, 64.0);
  CHECK(stripes.aspect > 2.0);
  CHECK(stripes.direction < -0.5);  // along y
}

TEST_CASE("light that comes in pairs is not taken for structure") {
  // Each ray leaves light in two neighbouring pixels: half as many independent hits, the same light.
  Tally pairs(fullSky(kSide), 1);
  for (int pixel = 0; pixel + 1 < pairs.pixels(); ++pixel) {
    RandomStream random(12, static_cast<std::uint64_t>(pixel), RandomPurpose::path);
    const int count = poisson(0.5, random);
    for (int i = 0; i < count; ++i) {
      const bool firstHalf = random.next() < 0.5;
      for (const int to : {pixel, pixel + 1}) pairs.add(to, Vec3(1.0), firstHalf);
    }
  }
  const Tally singles = poissonTally(
      fullSky(kSide), [](int, int) { return 0.5; }, 12);
  const auto deviation = [](const Tally& tally) {
    const std::vector<double> light = adaptiveLight(tally);
    double mean = 0.0, squares = 0.0;
    for (const double l : light) {
      mean += l / static_cast<double>(light.size());
      squares += l * l / static_cast<double>(light.size());
    }
    return std::sqrt(squares / (mean * mean) - 1.0);
  };
  CHECK(deviation(pairs) < 1.5 * deviation(singles));
}

TEST_CASE("the variance is that of pictures of other rays") {
  const auto density = [](int x, int y) { return std::abs(x - 96) < 6 ? 8.0 : y < 96 ? 0.2 : 1.0; };
  constexpr int kPictures = 24;
  std::vector<double> sum(kSide * kSide), squares(sum), claimed(sum);
  for (int i = 0; i < kPictures; ++i) {
    const Image image = adaptive(poissonTally(fullSky(kSide), density, 100 + i));
    for (std::size_t p = 0; p < sum.size(); ++p) {
      const double l = static_cast<double>((*image.find("G"))[p]);
      sum[p] += l;
      squares[p] += l * l;
      claimed[p] += static_cast<double>((*image.find(kVarianceChannel))[p]);
    }
  }
  // Over the dim, the bright and the arc, each without its edges.
  const auto ratio = [&](int x0, int x1, int y0, int y1) {
    double c = 0.0, t = 0.0;
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        const auto p = static_cast<std::size_t>(y * kSide + x);
        c += claimed[p] / kPictures;
        t += (squares[p] - sum[p] * sum[p] / kPictures) / (kPictures - 1);
      }
    }
    return c / t;
  };
  for (const double r : {ratio(0, 80, 0, 80), ratio(0, 80, 112, 192), ratio(94, 98, 0, 192)}) {
    CHECK(r > 0.5);
    CHECK(r < 1.6);
  }
}

TEST_CASE("the bias of a thin arc covers what it lacks, and that of flat sky is less than the sky") {
  // A line of one pixel, 20 times as bright as the sky: a few hits blur it.
  for (const double sky : {0.05, 0.2, 20.0}) {
    const auto density = [&](int x, int) { return x == 96 ? 20.0 * sky : sky; };
    const Tally tally = poissonTally(fullSky(kSide), density, 41);
    const Image image = adaptive(tally);
    const std::vector<double> light = perPixel(image, tally), bias = perPixel(image, tally, kBiasChannel);
    double lacks = 0.0, claimed = 0.0, flat = 0.0;
    for (int y = 40; y < 152; ++y) {
      const auto at = [&](int x) { return static_cast<std::size_t>(y * kSide + x); };
      lacks += (density(96, y) - light[at(96)]) / 112.0;
      claimed += bias[at(96)] / 112.0;
      flat += bias[at(40)] / light[at(40)] / 112.0;
    }
    CHECK(claimed > std::abs(lacks));
    CHECK(flat < (sky > 1.0 ? 0.15 : 1.0));  // of the light; a pixel's own light has a noise of 0.22
  }
}

TEST_CASE("the bias is light: a thousandth of the weight is a thousandth of the bias") {
  const auto density = [](int x, int y) { return std::abs(x - y) < 3 ? 4.0 : 0.2; };
  const Image whole = adaptive(poissonTally(fullSky(kSide), density, 42));
  const Image faint = adaptive(poissonTally(fullSky(kSide), density, 42, 1.0 / 1024.0));
  double sum = 0.0, faintSum = 0.0;
  for (std::size_t i = 0; i < whole.pixels(); ++i) {
    sum += static_cast<double>((*whole.find(kBiasChannel))[i]);
    faintSum += 1024.0 * static_cast<double>((*faint.find(kBiasChannel))[i]);
  }
  CHECK(sum > 0.0);
  CHECK(faintSum == doctest::Approx(sum).epsilon(1e-4));
}

}  // namespace parhelion
