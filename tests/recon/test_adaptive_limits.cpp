// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <tbb/task_arena.h>

#include "synthetic_tally.h"

namespace parhelion {
namespace {

constexpr int kSide = 128;

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// The same light in every pixel's steradian, as one hit each.
Tally evenSky(const TallyInfo& info) {
  Tally tally(info, 1);
  const std::vector<double> solidAngles = Camera(info.camera).solidAngles();
  const double mean =
      sum(solidAngles) / static_cast<double>(std::ranges::count_if(solidAngles, [](double o) { return o > 0.0; }));
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) {
    const double omega = solidAngles[static_cast<std::size_t>(pixel)];
    if (omega > 0.0) tally.add(pixel, Vec3(omega / mean), (pixel + pixel / tally.width()) % 2 == 0);
  }
  return tally;
}

/// Largest deviation of the luminance from its mean over the sky, relative.
double unevenness(const Tally& tally) {
  const Image image = adaptive(tally);
  const std::vector<double> solidAngles = Camera(tally.info.camera).solidAngles();
  const double mean = sum(perPixel(image, tally)) / (sum(solidAngles) * tally.info.interceptedLight());
  double worst = 0.0;
  for (std::size_t i = 0; i < solidAngles.size(); ++i)
    if (solidAngles[i] > 0.0)
      worst = std::max(worst, std::abs(static_cast<double>((*image.find("G"))[i]) / mean - 1.0));
  return worst;
}

}  // namespace

TEST_CASE("an even sky is even up to the border of the picture and of the image circle") {
  CHECK(unevenness(evenSky(fullSky(kSide))) < 1e-3);
  TallyInfo circle = fullSky(kSide);
  circle.camera.fieldOfView = radians(180.0);
  CHECK(unevenness(evenSky(circle)) < 1e-3);
}

TEST_CASE("an even sky is even where the projection distorts") {
  TallyInfo info = fullSky(kSide);
  info.camera.projection = Projection::fisheyeStereographic;
  info.camera.fieldOfView = radians(180.0);
  CHECK(unevenness(evenSky(info)) < 0.05);
  info.camera.projection = Projection::rectilinear;
  info.camera.fieldOfView = radians(120.0);
  CHECK(unevenness(evenSky(info)) < 0.05);
  info.camera.projection = Projection::equirectangular;
  info.camera.fieldOfView = radians(360.0);
  info.camera.height = kSide / 2;
  CHECK(unevenness(evenSky(info)) < 0.15);  // at the poles
}

TEST_CASE("an empty tally and hits outside the image circle give black") {
  TallyInfo info = fullSky(kSide);
  info.camera.fieldOfView = radians(180.0);
  Tally tally(info, 1);
  for (int i = 0; i < 2; ++i) {
    const Image image = adaptive(tally);
    for (const Channel& channel : image.channels)
      CHECK(std::ranges::all_of(channel.samples, [](float s) { return s == 0.0F; }));
    addHits(tally, 0, 10);
  }
  addHits(tally, kSide * kSide / 2, 5);
  const std::vector<double> light = adaptiveLight(tally);
  CHECK(light[0] == 0.0);
  CHECK(sum(light) == doctest::Approx(5.0).epsilon(1e-6));
}

TEST_CASE("one hit keeps its light, anywhere") {
  for (const int pixel : {0, kSide - 1, kSide * kSide / 2 + kSide / 2, kSide * kSide - 1}) {
    Tally tally(fullSky(kSide), 1);
    addHits(tally, pixel, 1);
    const std::vector<double> light = adaptiveLight(tally);
    CHECK(sum(light) == doctest::Approx(1.0).epsilon(1e-6));
    CHECK(*std::ranges::min_element(light) >= 0.0);
  }
}

TEST_CASE("a pile of hits stays where it is, with no ring and no harm to its surroundings") {
  for (const double pile : {5e3, 1e8}) {
    Tally tally = poissonTally(
        fullSky(kSide), [](int, int) { return 0.1; }, 7);
    const int centre = kSide * kSide / 2 + kSide / 2;
    const auto add = [&](int slot, double amount, double scale) {
      tally.setRaw(centre, slot, tally.raw(centre, slot) + toFixed(amount, scale));
    };
    add(Tally::kY, pile, kWeightScale);
    add(Tally::kFirstHalf, 0.5 * pile, kWeightScale);
    add(Tally::kSquares, pile, kSquareScale);
    add(Tally::kHits, pile, 1.0);
    const std::vector<double> light = adaptiveLight(tally);
    CHECK(sum(light) == doctest::Approx(lightIn(tally)).epsilon(1e-6));
    CHECK(light[static_cast<std::size_t>(centre)] > 0.99 * pile);
    double around = 0.0;
    for (int i = 0; i < kSide * kSide; ++i) {
      const double distance = std::hypot(i % kSide - kSide / 2, i / kSide - kSide / 2);
      if (distance < 2.0) continue;
      const double l = light[static_cast<std::size_t>(i)];
      REQUIRE(l >= 0.0);
      CHECK(l < 1.0);
      around += l;
    }
    CHECK(around == doctest::Approx(0.1 * kSide * kSide).epsilon(0.2));
  }
}

TEST_CASE("light in another unit changes nothing but the unit") {
  const auto density = [](int x, int) { return x < 40 ? 0.1 : 1.0; };
  const Image one = adaptive(poissonTally(fullSky(kSide), density, 8));
  const Image small = adaptive(poissonTally(fullSky(kSide), density, 8, 0x1p-10));
  const Image odd = adaptive(poissonTally(fullSky(kSide), density, 8, 1e-3));
  for (std::size_t i = 0; i < one.pixels(); ++i) {
    const float whole = one.channels[1].samples[i];
    REQUIRE(small.channels[1].samples[i] == 0x1p-10F * whole);
    REQUIRE(odd.channels[1].samples[i] == doctest::Approx(1e-3F * whole).epsilon(1e-4));
  }
}

TEST_CASE("any number of threads gives the same bits") {
  TallyInfo info = fullSky(300);
  info.camera.fieldOfView = radians(180.0);
  Tally tally(info, 3);
  for (std::uint64_t i = 0; i < 30'000; ++i) {
    RandomStream random(9, i, RandomPurpose::path);
    const int pixel = static_cast<int>(random.next() * random.next() * tally.pixels());
    tally.add(pixel, {random.next(), random.next(), random.next()}, i % 2 == 0);
  }
  const auto with = [&](int threads) {
    tbb::task_arena arena(threads);
    return arena.execute([&] { return adaptive(tally); });
  };
  const Image one = with(1);
  for (const int threads : {2, 5}) {
    const Image many = with(threads);
    for (std::size_t c = 0; c < one.channels.size(); ++c) CHECK(one.channels[c].samples == many.channels[c].samples);
  }
}

}  // namespace parhelion
