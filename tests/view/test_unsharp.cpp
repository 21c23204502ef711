// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "pictures.h"
#include "view/gaussian_blur.h"
#include "view/unsharp.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

/// A Gaussian's share of what lies below `x` standard deviations.
double below(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

}  // namespace

TEST_CASE("a constant picture comes out of the unsharp mask bit for bit") {
  for (const int level : {0, 1, 77, 128, 254, 255})
    for (const double radius : {0.3, 1.0, 7.7, 300.0}) {
      const Display before = display(53, 41, [=](int c, int, int) { return (level * (3 - c) / 3) / 255.0; });
      Display after = before;
      unsharp(after, {8.0, radius});
      CHECK(after.planes == before.planes);
    }
}

TEST_CASE("the blur of an edge is the Gaussian's integral within its stated error") {
  constexpr int kSize = 256, kEdge = 128;
  for (const double sigma : {1.3, 1.7, 3.0, 10.0, 21.5}) {
    std::vector<float> upright(kSize * 3), lying(kSize * 3);
    for (int i = 0; i < kSize; ++i)
      for (int j = 0; j < 3; ++j) {
        upright[static_cast<std::size_t>(j * kSize + i)] = i < kEdge ? 0.0F : 1.0F;
        lying[static_cast<std::size_t>(3 * i + j)] = i < kEdge ? 0.0F : 1.0F;
      }
    blurGaussian(upright, kSize, 3, sigma);
    blurGaussian(lying, 3, kSize, sigma);
    for (int i = 0; i < kSize; ++i) {
      const double exact = below((i + 0.5 - kEdge) / sigma);
      CHECK(std::abs(upright[static_cast<std::size_t>(kSize + i)] - exact) < kBlurError);
      CHECK(lying[static_cast<std::size_t>(3 * i + 1)] == upright[static_cast<std::size_t>(kSize + i)]);
    }
  }
}

TEST_CASE("the blur of a point has the Gaussian's variance in both directions, and all of the light") {
  constexpr int kSize = 201, kMiddle = 100;
  for (const double sigma : {0.4, 1.0, 2.3, 9.1, 16.0}) {
    std::vector<float> plane(kSize * kSize);
    plane[kMiddle * kSize + kMiddle] = 1.0F;
    blurGaussian(plane, kSize, kSize, sigma);
    double sum = 0.0, xx = 0.0, yy = 0.0;
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const double value = plane[static_cast<std::size_t>(y * kSize + x)];
        sum += value;
        xx += value * (x - kMiddle) * (x - kMiddle);
        yy += value * (y - kMiddle) * (y - kMiddle);
      }
    CHECK(sum == doctest::Approx(1.0).epsilon(1e-6));  // floats
    CHECK(xx == doctest::Approx(sigma * sigma).epsilon(1e-5));
    CHECK(yy == doctest::Approx(sigma * sigma).epsilon(1e-5));
  }
}

TEST_CASE("the unsharp mask raises an edge by its amount times what the blur takes") {
  constexpr double kLow = 0.4, kHigh = 0.5, kAmount = 2.0, kSigma = 6.0;
  constexpr double kBound = kBlurError * kAmount * (kHigh - kLow);
  Display picture = display(128, 5, [](int, int x, int) { return x < 64 ? kLow : kHigh; });
  unsharp(picture, {kAmount, kSigma});
  for (int x = 0; x < 128; ++x) {
    const double before = x < 64 ? kLow : kHigh;
    const double mean = kLow + (kHigh - kLow) * below((x + 0.5 - 64) / kSigma);
    for (const auto& plane : picture.planes)
      CHECK(std::abs(plane[static_cast<std::size_t>(2 * 128 + x)] - (before + kAmount * (before - mean))) < kBound);
  }
}

TEST_CASE("the unsharp mask ends at black and white") {
  Display picture = display(64, 64, [](int, int x, int y) { return (x / 8 + y / 8) % 2 ? 0.9 : 0.1; });
  unsharp(picture, {50.0, 5.0});
  for (const float value : picture.planes[1]) CHECK((value >= 0.0F && value <= 1.0F));
  CHECK(*std::max_element(picture.planes[1].begin(), picture.planes[1].end()) == 1.0F);
}

TEST_CASE("a photograph and a simulation that look alike look alike after the unsharp mask") {
  const Image sky = light(96, 64, [](int c, int x, int y) { return 0.02 * (c + 1) + 0.01 * ((x / 7 + y / 9) % 5); });
  const Preview developedSky = developPreview(sky, {1.0});
  Photograph photograph;
  photograph.width = 96;
  photograph.height = 64;
  photograph.samples = developedSky.rgb;
  Display fromSky = developed(sky, {1.0}), fromPhotograph = shown(photograph);
  unsharp(fromSky, {3.0, 4.0});
  unsharp(fromPhotograph, {3.0, 4.0});
  // The photograph was rounded to steps of 1/255, dithered: at most one step, four times with an amount of 3, its mean
  // less.
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < fromSky.pixels(); ++i)
      CHECK(std::abs(fromSky.planes[c][i] - fromPhotograph.planes[c][i]) < 7.0 / 255.0);
}

TEST_CASE("a blur without a width is refused") {
  std::vector<float> plane(12);
  for (const double sigma : {0.0, -1.0, std::nan(""), 1e5})
    CHECK_THROWS_AS(blurGaussian(plane, 4, 3, sigma), std::invalid_argument);
  CHECK_THROWS_AS(blurGaussian(plane, 5, 3, 1.0), std::invalid_argument);
}
