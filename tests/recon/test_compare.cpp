// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include <glm/matrix.hpp>

#include "parallel/threads.h"
#include "picture/colour_space.h"
#include "recon/compare.h"
#include "synthetic_tally.h"

namespace parhelion {
namespace {

/// A grey picture of value(x, y) times the radiance that `light` a pixel has in the middle of the tally's picture.
template <class F>
Image greySky(const TallyInfo& info, double light, const F& value) {
  Image image{info.camera.width, info.camera.height, {}};
  const std::vector<double> solidAngles = Camera(info.camera).solidAngles();
  const double middle = solidAngles[static_cast<std::size_t>((image.height / 2) * image.width + image.width / 2)];
  for (const char* name : {"R", "G", "B"}) {
    std::vector<float>& plane = image.add(name);
    for (std::size_t i = 0; i < plane.size(); ++i)
      if (solidAngles[i] > 0.0)
        plane[i] = static_cast<float>(light / (info.interceptedLight() * middle) *
                                      value(static_cast<int>(i) % image.width, static_cast<int>(i) / image.width));
  }
  return image;
}

/// Light value(x, y) in both halves of each pixel, per solid angle of the middle pixel.
template <class F>
Tally exactTally(const TallyInfo& info, const F& value) {
  Tally tally(info, 1);
  const std::vector<double> solidAngles = Camera(info.camera).solidAngles();
  const double middle = solidAngles[static_cast<std::size_t>((tally.height() / 2) * tally.width() + tally.width() / 2)];
  for (int i = 0; i < tally.pixels(); ++i)
    for (const bool half : {true, false})
      tally.add(i,
                Vec3(solidAngles[static_cast<std::size_t>(i)] / middle * value(i % tally.width(), i / tally.width())),
                half);
  return tally;
}

/// Poisson hits that hold nothing but the sum and its halves; the latter by chance.
template <class Density>
Tally countTally(TallyInfo info, const Density& density, std::uint64_t seed) {
  info.seed = seed;
  Tally tally(info, 1);
  for (int i = 0; i < tally.pixels(); ++i) {
    RandomStream random(seed, static_cast<std::uint64_t>(i), RandomPurpose::path);
    const double mean = 0.5 * density(i % tally.width(), i / tally.width());
    const int first = poisson(mean, random), second = poisson(mean, random);
    tally.setRaw(i, Tally::kY, toFixed(first + second));
    tally.setRaw(i, Tally::kFirstHalf, toFixed(first));
  }
  return tally;
}

bool near(double value, double expected, double relative = 1e-5) {
  return std::abs(value - expected) <= relative * std::abs(expected);
}

double square(double x) { return x * x; }

}  // namespace

TEST_CASE("a picture of 2 x 2 pixels has the errors that the formulas give by hand") {
  // Columns: reference 0.5 and 1.5, picture -0.5 and 2.5 of the mean.
  const TallyInfo info = fullSky(2);
  const Tally tally = exactTally(info, [](int x, int) { return x == 0 ? 1.0 : 3.0; });
  const Image sky = greySky(info, 4.0, [](int x, int) { return x == 0 ? -0.5 : 2.5; });
  const Comparison c = compare(sky, tally);

  const double w = std::exp(-0.5), left = (0.5 + 1.5 * w) / (1.0 + w), right = (1.5 + 0.5 * w) / (1.0 + w);
  CHECK(near(c.relMse, 0.5 / (left * left + 0.01) + 0.5 / (right * right + 0.01)));
  CHECK(near(c.mse, 1.0));
  CHECK(near(c.logMse, 0.5 * (square(std::log(0.01 / 0.51)) + square(std::log(2.51 / 1.51)))));
  CHECK(std::abs(c.energyError) < 1e-6);
  CHECK(near(c.negativePixels, 0.5));

  // Brightness in the window of 1.5 pixels, whose weights are 1 and v, on the left and on the right.
  const auto tone = [](double x) { return std::log(1.0 + 10.0 * x) / std::log(1001.0); };
  const double v = std::exp(-0.5 / 2.25), n = 1.0 + v;
  const double e0 = tone(0.0), e1 = tone(2.5), r0 = tone(0.5), r1 = tone(1.5);
  const double covariance = v / (n * n) * (e1 - e0) * (r1 - r0);
  const double variances = v / (n * n) * (square(e1 - e0) + square(r1 - r0));
  const auto ssim = [&](double e, double r) {
    return (2.0 * e * r + 1e-4) * (2.0 * covariance + 9e-4) / ((e * e + r * r + 1e-4) * (variances + 9e-4));
  };
  CHECK(near(c.ssim, 0.5 * (ssim((e0 + v * e1) / n, (r0 + v * r1) / n) + ssim((e1 + v * e0) / n, (r1 + v * r0) / n))));
  CHECK_FALSE(c.relMseRgb.has_value());
}

TEST_CASE("up to the image circle's border all of the sky counts, and no more than it") {
  TallyInfo info = fullSky(64);
  info.camera.fieldOfView = radians(180.0);
  const Tally flat = exactTally(info, [](int, int) { return 1000.0; });
  const Image halves = greySky(info, 2000.0, [](int x, int) { return x < 32 ? 0.9 : 1.1; });
  const Comparison c = compare(halves, flat);
  CHECK(near(c.relMse, 0.01 / 1.01));
  CHECK(near(c.mse, 0.01));
  CHECK(std::abs(c.energyError) < 1e-6);
  CHECK(near(compare(greySky(info, 1.0, [](int, int) { return 1.0; }), flat).ssim, 1.0));
}

TEST_CASE("pixels count by their solid angle") {
  // Errors of 0.1 nearer to the poles than 30 degrees: a third of the pixels, 1 - sin 60 degrees of the sky.
  TallyInfo info = fullSky(96);
  info.camera.projection = Projection::equirectangular;
  info.camera.fieldOfView = radians(360.0);
  info.camera.elevation = 0.0;
  info.camera.height = 48;
  const Tally flat = exactTally(info, [](int, int) { return 1000.0; });
  const Image sky = greySky(info, 2000.0, [](int x, int y) { return y >= 8 && y < 40 ? 1.0 : x < 48 ? 0.9 : 1.1; });
  CHECK(near(compare(sky, flat).mse, 0.01 * (1.0 - std::sqrt(0.75)), 1e-4));
}

TEST_CASE("against noisy references the truth has no error, within four standard errors that are right") {
  constexpr int kSide = 128, kSeeds = 12;
  const TallyInfo info = fullSky(kSide);
  const auto density = [](int x, int) { return 20.0 + 40.0 * x / (kSide - 1.0); };
  const Image truth = greySky(info, 1.0, density);
  double squares = 0.0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const Tally a = countTally(info, density, 2 * seed + 1), b = countTally(info, density, 2 * seed + 2);
    const Comparison c = compare(truth, a, &b);
    // The scatter of a pixel is 0.16 of the mean: its square 0.028 would be the error without the second estimate.
    CHECK(std::abs(c.relMse) < 4.0 * c.relMseError);
    CHECK(c.relMseError < 5e-4);
    CHECK(std::abs(c.logMse) < 2e-3);
    const Comparison halves = compare(truth, a);
    CHECK(std::abs(halves.relMse) < 4.0 * halves.relMseError);
    squares += square(c.relMse / c.relMseError) / kSeeds;
  }
  // Of 12 numbers of unit variance the mean square is 1 with a scatter of sqrt(2/12); three of these.
  CHECK(std::abs(squares - 1.0) < 3.0 * std::sqrt(2.0 / kSeeds));
}

TEST_CASE("a real error is measured through the noise of the reference, four standard errors") {
  const TallyInfo info = fullSky(128);
  const auto flat = [](int, int) { return 40.0; };
  const Image wrong = greySky(info, 40.0, [](int x, int y) { return (x + y) % 2 ? 0.95 : 1.05; });
  const Tally a = countTally(info, flat, 1), b = countTally(info, flat, 2);
  const Comparison c = compare(wrong, a, &b);
  CHECK(std::abs(c.relMse - 0.0025 / 1.01) < 4.0 * c.relMseError);
  CHECK(c.relMseError < 5e-4);
}

TEST_CASE("a brighter picture has the same errors and the energy error of its scale") {
  const TallyInfo info = fullSky(32);
  const auto density = [](int x, int y) { return 5.0 + x + 0.2 * y; };
  const Tally tally = countTally(info, density, 1);
  const Image one = greySky(info, 1.0, density), three = greySky(info, 3.0, density);
  const Comparison c = compare(one, tally), scaled = compare(three, tally);
  CHECK(near(scaled.relMse, c.relMse));
  CHECK(near(scaled.mse, c.mse));
  CHECK(near(scaled.logMse, c.logMse));
  CHECK(near(scaled.ssim, c.ssim));
  CHECK(near(1.0 + scaled.energyError, 3.0 * (1.0 + c.energyError)));
  const Comparison own = compare(plainRadiance(tally), tally);
  CHECK(std::abs(own.energyError) < 1e-6);
  CHECK(own.relMse < 0.0);  // (e - A)(e - B) for e = (A + B)/2
}

TEST_CASE("colour errors are those of each channel, and coloured light keeps its luminance") {
  TallyInfo info = fullSky(16);
  info.white = {0.9, 1.0, 0.7};
  const auto filled = [&](std::uint64_t seed, const Vec3& xyz) {
    info.seed = seed;
    Tally tally(info, 3);
    for (int i = 0; i < tally.pixels(); ++i) addHits(tally, i, 10, xyz);
    return tally;
  };
  const Tally a = filled(1, info.white), b = filled(2, info.white);
  const Mat3 toXyz = glm::inverse(xyzToRec709(info.white));
  const double red = 0.1, blue = 0.2, green = -(toXyz[0].y * red + toXyz[2].y * blue) / toXyz[1].y;
  Image cast = plainRadiance(a);
  for (std::size_t i = 0; i < cast.pixels(); ++i) {
    cast.channels[0].samples[i] *= static_cast<float>(1.0 + red);
    cast.channels[1].samples[i] *= static_cast<float>(1.0 + green);
    cast.channels[2].samples[i] *= static_cast<float>(1.0 + blue);
  }
  const Comparison c = compare(cast, a, &b);
  REQUIRE(c.relMseRgb.has_value());
  CHECK(near((*c.relMseRgb)[0], red * red / 1.01, 1e-4));
  CHECK(near((*c.relMseRgb)[1], green * green / 1.01, 1e-4));
  CHECK(near((*c.relMseRgb)[2], blue * blue / 1.01, 1e-4));
  CHECK(near(c.meanRelMseRgb(), (red * red + green * green + blue * blue) / 3.03, 1e-4));
  CHECK(std::abs(c.relMse) < 1e-9);

  // Red beyond the gamut.
  const Tally strong = filled(1, {0.6, 0.3, 0.0});
  const Comparison own = compare(plainRadiance(strong), strong);
  CHECK(std::abs(own.energyError) < 1e-6);
  CHECK(own.negativePixels == 0.0);
}

TEST_CASE("references of other pictures, of the same rays or without light are refused") {
  const TallyInfo info = fullSky(8);
  const auto flat = [](int, int) { return 1.0; };
  const Image sky = greySky(info, 1.0, flat);
  const Tally a = exactTally(info, flat);
  const auto compareWith = [&](const TallyInfo& other) {
    const Tally b = exactTally(other, flat);
    return compare(sky, a, &b);
  };
  TallyInfo other = info;
  CHECK_THROWS_WITH_AS(compareWith(other), "they hold the same rays of the same seed, trace one with another seed",
                       std::invalid_argument);
  other.rays = {{999'999, 10}};  // one ray is in both
  CHECK_THROWS_WITH_AS(compareWith(other), "they hold the same rays of the same seed, trace one with another seed",
                       std::invalid_argument);
  other.rays = {{1'000'000, 10}};
  CHECK_NOTHROW(compareWith(other));
  other = info;
  other.seed = 2;
  CHECK_NOTHROW(compareWith(other));
  other.camera.azimuth = 0.1;
  CHECK_THROWS_WITH_AS(compareWith(other), "their cameras differ", std::invalid_argument);
  other.camera = info.camera;
  other.sunElevation = 0.5;
  CHECK_THROWS_WITH_AS(compareWith(other), "their suns differ", std::invalid_argument);

  CHECK_THROWS_AS(compare(greySky(fullSky(9), 1.0, flat), a), std::invalid_argument);
  Tally half(info, 1);
  half.add(3, Vec3(1.0), true);
  CHECK_THROWS_WITH_AS(compare(sky, half), "half of the reference holds no light", std::invalid_argument);
}

TEST_CASE("a black picture and one that is not finite give errors that say so") {
  const TallyInfo info = fullSky(8);
  const auto flat = [](int, int) { return 1.0; };
  const Tally tally = exactTally(info, flat);
  const Comparison black = compare(greySky(info, 0.0, flat), tally);
  CHECK(black.energyError == -1.0);
  CHECK(near(black.relMse, 1.0 / 1.01));
  const Image broken = greySky(info, 1.0, [](int x, int y) { return x == 3 && y == 3 ? NAN : 1.0; });
  const Comparison c = compare(broken, tally);
  for (const double value : {c.relMse, c.mse, c.logMse, c.ssim, c.energyError}) CHECK(std::isnan(value));
}

TEST_CASE("comparisons have the same bits for any number of threads") {
  const TallyInfo info = fullSky(100);
  const auto density = [](int x, int y) { return 1.0 + 0.1 * x + 0.01 * y; };
  const Tally tally = countTally(info, density, 5);
  const auto numbers = [&](int threads) {
    const Comparison c = withThreads(threads, [&] { return compare(greySky(info, 1.0, density), tally); });
    return std::array{c.relMse, c.relMseError, c.mse, c.logMse, c.ssim, c.energyError};
  };
  CHECK(numbers(1) == numbers(7));
}

}  // namespace parhelion
