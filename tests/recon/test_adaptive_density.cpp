// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "synthetic_tally.h"

namespace parhelion {
namespace {

constexpr int kSide = 192;

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// Mean over the columns [from, to) of all rows.
double columns(const std::vector<double>& light, int from, int to) {
  double total = 0.0;
  for (int y = 0; y < kSide; ++y)
    for (int x = from; x < to; ++x) total += light[static_cast<std::size_t>(y) * kSide + x];
  return total / (kSide * (to - from));
}

std::vector<double> hits(const Tally& tally) {
  std::vector<double> light(static_cast<std::size_t>(tally.pixels()));
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) light[static_cast<std::size_t>(pixel)] = tally.luminance(pixel);
  return light;
}

double step(int x, int) { return x < kSide / 2 ? 0.02 : 2.0; }

/// Standard deviation over mean.
double relativeDeviation(const std::vector<double>& light) {
  const double mean = sum(light) / static_cast<double>(light.size());
  double squares = 0.0;
  for (const double l : light) squares += (l - mean) * (l - mean);
  return std::sqrt(squares / static_cast<double>(light.size())) / mean;
}

}  // namespace

TEST_CASE("two half planes of densities 0.02 and 2 keep their ratio of 100") {
  const Tally tally = poissonTally(fullSky(kSide), step, 1);
  const std::vector<double> light = adaptiveLight(tally), truth = hits(tally);
  const int edge = kSide / 2, margin = 12;
  const double ratio = columns(light, edge + margin, kSide) / columns(light, 0, edge - margin);
  const double hitRatio = columns(truth, edge + margin, kSide) / columns(truth, 0, edge - margin);
  CHECK(ratio / hitRatio == doctest::Approx(1.0).epsilon(0.05));
}

TEST_CASE("a step of 100 neither rings nor overshoots") {
  std::vector<double> light(static_cast<std::size_t>(kSide) * kSide);
  constexpr int kPictures = 4;
  for (int i = 0; i < kPictures; ++i) {
    const std::vector<double> one = adaptiveLight(poissonTally(fullSky(kSide), step, 10 + i));
    CHECK(*std::min_element(one.begin(), one.end()) >= 0.0);
    for (std::size_t p = 0; p < light.size(); ++p) light[p] += one[p] / kPictures;
  }
  for (int x = 0; x < kSide; ++x) CHECK(columns(light, x, x + 1) < 1.1 * 2.0);
  // The edge itself: within 3 pixels from a tenth to nine tenths.
  CHECK(columns(light, kSide / 2 - 3, kSide / 2 - 2) < 0.2);
  CHECK(columns(light, kSide / 2 + 2, kSide / 2 + 3) > 1.8);
}

TEST_CASE("a hole in the sky is dark, without a ring around it") {
  const auto distance = [](int x, int y) { return std::hypot(x - 96.0, y - 96.0); };
  const Tally tally = poissonTally(
      fullSky(kSide), [&](int x, int y) { return distance(x, y) < 24.0 ? 0.0 : 2.0; }, 2);
  const std::vector<double> light = adaptiveLight(tally);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double l = light[static_cast<std::size_t>(y) * kSide + x];
      REQUIRE(std::isfinite(l));
      REQUIRE(l >= 0.0);
      REQUIRE(l < 4.0);
      if (distance(x, y) < 16.0) REQUIRE(l < 0.02);
    }
  }
}

TEST_CASE("an edge like a halo's, 1/sqrt of the distance, leaks less than 5 % of the peak 6 pixels into the dark") {
  constexpr double kEdge = 96.0;
  // Mean over a pixel of 1/sqrt(x - edge), 0 in the dark.
  const auto edge = [](int x) {
    return 2.0 * (std::sqrt(std::max(x + 1 - kEdge, 0.0)) - std::sqrt(std::max(x - kEdge, 0.0)));
  };
  double leak[2];
  for (int i = 0; i < 2; ++i) {
    const double scale = i == 0 ? 0.3 : 30.0;
    const std::vector<double> light = adaptiveLight(poissonTally(
        fullSky(kSide), [&](int x, int) { return scale * edge(x); }, 3));
    double peak = 0.0;
    for (int x = 0; x < kSide; ++x) peak = std::max(peak, columns(light, x, x + 1));
    leak[i] = columns(light, 90, 91) / peak;
  }
  CHECK(leak[0] < 0.05);
  CHECK(leak[1] < 0.3 * leak[0]);
}

TEST_CASE("a flat sky comes out flat: noise falls as hits grow, no specks") {
  const double densities[] = {0.01, 0.1, 1.0, 10.0, 100.0};
  const double deviations[] = {0.147, 0.102, 0.058, 0.034, 0.020};
  for (int i = 0; i < 5; ++i) {
    const std::vector<double> light = adaptiveLight(poissonTally(
        fullSky(512), [&](int, int) { return densities[i]; }, 4));
    INFO("density " << densities[i]);
    CHECK(relativeDeviation(light) < 1.2 * deviations[i]);
    if (densities[i] >= 0.1) CHECK(*std::max_element(light.begin(), light.end()) < 2.0 * densities[i]);
  }
}

TEST_CASE("all light is kept, in every projection") {
  for (const Projection projection :
       {Projection::rectilinear, Projection::fisheyeEqualArea, Projection::fisheyeStereographic,
        Projection::fisheyeOrthographic, Projection::equirectangular}) {
    TallyInfo info = fullSky(128);
    info.camera.projection = projection;
    info.camera.fieldOfView = projection == Projection::equirectangular ? radians(360.0) : radians(120.0);
    const Tally tally = poissonTally(
        info, [](int x, int y) { return x < y ? 0.05 : 0.5; }, 5);
    CHECK(std::abs(sum(adaptiveLight(tally)) / lightIn(tally) - 1.0) < 1e-6);
  }
}

TEST_CASE("where every pixel has many hits, the reconstruction tends to the plain radiance") {
  const Tally tally = poissonTally(
      fullSky(64), [](int x, int y) { return 2000.0 * (2.0 + std::sin(0.4 * x) * std::cos(0.3 * y)); }, 6);
  const std::vector<double> light = adaptiveLight(tally), plain = hits(tally);
  for (std::size_t i = 0; i < light.size(); ++i) CHECK(light[i] == doctest::Approx(plain[i]).epsilon(0.1));
}

}  // namespace parhelion
