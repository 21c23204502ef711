// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "math/conventions.h"
#include "painting.h"
#include "photo/guided_filter.h"

namespace parhelion {

namespace {

// Single precision of values up to 1, a few operations long.
constexpr double kRounding = 2e-5;

struct Pair {
  Raster<GuideColour> guide;
  Raster<float> input;
};

Pair randomPair(int width, int height) {
  Dice dice(7);
  Pair pair{{width, height}, {width, height}};
  for (GuideColour& colour : pair.guide) {
    for (float& c : colour) c = static_cast<float>(dice.between(0.0, 1.0));
  }
  for (float& p : pair.input) p = static_cast<float>(dice.between(0.0, 1.0));
  return pair;
}

struct Line {
  Vec3 slope;
  double offset;
};

template <class F>
int eachInWindow(int width, int height, int x, int y, int radius, const F& f) {
  int count = 0;
  for (int j = std::max(0, y - radius); j <= std::min(height - 1, y + radius); ++j) {
    for (int i = std::max(0, x - radius); i <= std::min(width - 1, x + radius); ++i, ++count) f(i, j);
  }
  return count;
}

// He, Sun & Tang 2013, equations 16 and 17, sum by sum.
Line lineByDefinition(const Pair& pair, int x, int y, int radius, double epsilon) {
  const auto each = [&](const auto& f) {
    return eachInWindow(pair.input.width(), pair.input.height(), x, y, radius, f);
  };
  const auto guide = [&](int i, int j) {
    const GuideColour& g = pair.guide.at(i, j);
    return Vec3(g[0], g[1], g[2]);
  };
  Vec3 mean{0.0};
  double meanInput = 0.0;
  const double count = each([&](int i, int j) {
    mean += guide(i, j);
    meanInput += static_cast<double>(pair.input.at(i, j));
  });
  mean /= count;
  meanInput /= count;
  Mat3 covariance(0.0);
  Vec3 product{0.0};
  each([&](int i, int j) {
    const Vec3 d = guide(i, j) - mean;
    covariance += glm::outerProduct(d, d) / count;
    product += d * ((static_cast<double>(pair.input.at(i, j)) - meanInput) / count);
  });
  const Vec3 slope = glm::inverse(covariance + epsilon * Mat3(1.0)) * product;
  return {slope, meanInput - glm::dot(slope, mean)};
}

}  // namespace

TEST_CASE("the guided filter is what He, Sun and Tang define") {
  constexpr int kWidth = 13, kHeight = 9, kRadius = 2;
  constexpr float kEpsilon = 0.01F;
  const Pair pair = randomPair(kWidth, kHeight);
  const GuidedFilter filter(pair.guide, pair.input, kRadius, kEpsilon);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const GuideColour& g = pair.guide.at(x, y);
      double sum = 0.0;
      const int count = eachInWindow(kWidth, kHeight, x, y, kRadius, [&](int i, int j) {
        const Line line = lineByDefinition(pair, i, j, kRadius, static_cast<double>(kEpsilon));
        sum += glm::dot(line.slope, Vec3(g[0], g[1], g[2])) + line.offset;
      });
      const auto found = static_cast<double>(filter.at(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F, g));
      CHECK(std::abs(found - sum / count) < kRounding);
    }
  }
}

TEST_CASE("the guided filter keeps a constant whatever the guide") {
  Pair pair = randomPair(20, 10);
  std::fill(pair.input.begin(), pair.input.end(), 0.75F);
  const GuidedFilter filter(pair.guide, pair.input, 3, 1e-4F);
  const auto found = static_cast<double>(filter.at(7.3F, 4.1F, {0.9F, 0.1F, 0.4F}));
  CHECK(std::abs(found - 0.75) < kRounding);
}

TEST_CASE("coefficients of a small picture follow an edge of the large one to the pixel") {
  // A slanted edge at 4 times the size: light sky above, dark land below.
  constexpr int kSmall = 24, kFactor = 4, kLarge = kSmall * kFactor;
  const auto colour = [](int x, int y) {
    return 3 * y < x + 150 ? GuideColour{0.6F, 0.7F, 0.9F} : GuideColour{0.2F, 0.25F, 0.1F};
  };
  Pair small{{kSmall, kSmall}, {kSmall, kSmall}};
  for (int y = 0; y < kLarge; ++y) {
    for (int x = 0; x < kLarge; ++x) {
      constexpr float kShare = 1.0F / (kFactor * kFactor);
      for (std::size_t c = 0; c < 3; ++c) small.guide.at(x / kFactor, y / kFactor)[c] += kShare * colour(x, y)[c];
    }
  }
  for (int y = 0; y < kSmall; ++y) {
    for (int x = 0; x < kSmall; ++x) small.input.at(x, y) = small.guide.at(x, y)[0] > 0.4F ? 1.0F : 0.0F;
  }
  const GuidedFilter filter(small.guide, small.input, 3, 1e-4F);
  int wrong = 0;
  for (int y = 0; y < kLarge; ++y) {
    for (int x = 0; x < kLarge; ++x) {
      const auto place = [](int pixel) { return (static_cast<float>(pixel) + 0.5F) / kFactor; };
      const bool sky = filter.at(place(x), place(y), colour(x, y)) > 0.5F;
      wrong += sky != (colour(x, y)[0] > 0.4F);
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("a guided filter refuses a guide of another size") {
  CHECK_THROWS_AS(GuidedFilter(Raster<GuideColour>(4, 4), Raster<float>(4, 5), 1, 1e-4F), std::invalid_argument);
}

}  // namespace parhelion
