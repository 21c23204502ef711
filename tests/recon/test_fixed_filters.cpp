// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "hit_maps.h"
#include "math/conventions.h"
#include "recon/methods.h"
#include "recon/published/fourier.h"
#include "recon/published/low_pass.h"

namespace parhelion {
namespace {

MethodOnMap gaussianOf(std::optional<double> sigma = {}) {
  return [sigma](const HitMap& map) { return reconstructHits(map, GaussianSettings{sigma}, {}); };
}

const MethodOnMap kGlassner = [](const HitMap& map) { return reconstructHits(map, GlassnerSettings{}, {}); };

HitMap withHit(HitMap map, int x, int y) {
  map.lights[0].at(x, y) = 1.0;
  return map;
}

}  // namespace

TEST_CASE("Gaussians leave a constant sky constant up to its border") {
  for (const double sigma : {0.3, 2.0, 9.0, 1000.0}) CHECK(errorOfConstantSky(gaussianOf(sigma)) < 1e-9);
  CHECK(errorOfConstantSky(kGlassner) < 1e-9);
}

TEST_CASE("Gaussians bear empty maps, single hits, piles and holes, and stay positive") {
  checkAwkwardMaps(gaussianOf());
  checkAwkwardMaps(kGlassner);
  const HitMap map = poissonHits(emptyDisc(100), 0.05, 2);
  for (const MethodOnMap& method : {gaussianOf(), kGlassner}) {
    CHECK(least(method(map).lights[0]) >= 0.0);
    CHECK(gain(method, map) == doctest::Approx(1.0).epsilon(0.05));
  }
}

TEST_CASE("Gaussians give the same bits for any number of threads and filter all lights alike") {
  checkThreadsAndLights(gaussianOf());
  checkThreadsAndLights(kGlassner);
}

TEST_CASE("a hit under a Gaussian has its standard deviation and its peak, also across edges that touch") {
  constexpr double kSigma = 3.0;
  const Reconstruction inside = reconstructHits(withHit(emptySky(64, 64, true), 32, 32), GaussianSettings{kSigma}, {});
  double variance = 0.0;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) variance += (x - 32) * (x - 32) * inside.lights[0].at(x, y);
  }
  CHECK(variance == doctest::Approx(kSigma * kSigma).epsilon(0.002));  // cut at 4 sigma
  CHECK(inside.lights[0].at(32, 32) == doctest::Approx(1.0 / (2.0 * kPi * kSigma * kSigma)).epsilon(0.001));

  const Reconstruction corner = reconstructHits(withHit(emptySky(64, 64, true), 0, 63), GaussianSettings{kSigma}, {});
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      CHECK(corner.lights[0].at(x, y) == doctest::Approx(inside.lights[0].at((x + 32) % 64, (y + 33) % 64)));
    }
  }
}

TEST_CASE("Glassner's filter is the mean of Gaussians of 1, 2, 4, ... pixels") {
  const HitMap map = withHit(emptySky(96, 96), 40, 50);
  const Reconstruction mean = reconstructHits(map, GlassnerSettings{4}, {});
  for (const int x : {40, 43, 49, 61}) {
    double sum = 0.0;
    for (const double sigma : {1.0, 2.0, 4.0, 8.0})
      sum += reconstructHits(map, GaussianSettings{sigma}, {}).lights[0].at(x, 52);
    CHECK(mean.lights[0].at(x, 52) == doctest::Approx(sum / 4.0));
  }
}

TEST_CASE("default filter sizes scale with the picture and shrink with the hits") {
  const auto remark = [](const HitMap& map) { return reconstructHits(map, GaussianSettings{}, {}).remarks.at(0); };
  // 0.074 px * sqrt(128 * 128) = 9.472 px for a single hit, 16^-0.224 = 0.537 of it for 16.
  HitMap map = withHit(emptySky(128, 128), 5, 5);
  CHECK(remark(map) == "sigma 9.47 px");
  map.lights[0].at(5, 5) = 16.0;
  CHECK(remark(map) == "sigma 5.09 px");
}

TEST_CASE("a Fourier transform of any size is undone by its inverse and knows a wave's frequency") {
  for (const int width : {1, 30, 49, 64, 77}) {
    const int height = 21;
    Raster<std::complex<double>> values(width, height);
    const int kx = width / 3;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const auto wave = portable::sincos(2.0 * kPi * (static_cast<double>(kx * x) / width + 4.0 * y / height));
        values.at(x, y) = {wave.cos, wave.sin};
      }
    }
    const auto original = values;
    fourier(values, false);
    const double count = width * height;
    CHECK(std::abs(values.at(kx, 4) - count) < 1e-9 * count);
    values.at(kx, 4) -= count;
    for (std::size_t i = 0; i < values.size(); ++i) CHECK(std::abs(values[i]) < 1e-9);
    values.at(kx, 4) += count;
    fourier(values, true);
    for (std::size_t i = 0; i < values.size(); ++i) CHECK(std::abs(values[i] / count - original[i]) < 1e-12);
  }
}

TEST_CASE("fast lengths have no prime factor above five") {
  CHECK(fastLength(1) == 1);
  CHECK(fastLength(7) == 8);
  CHECK(fastLength(31) == 32);
  CHECK(fastLength(1009) == 1024);
  CHECK(fastLength(961) == 972);
}

TEST_CASE("the ideal low-pass of period 8 px passes 197 waves of a torus of 128 px") {
  int passed = 0;
  for (int ky = -64; ky <= 64; ++ky) {
    for (int kx = -64; kx <= 64; ++kx) passed += passes(kx, 128, ky, 128, 8.0) ? 1 : 0;
  }
  CHECK(passed == 197);

  // An impulse holds all waves alike, and keeps the share that passes.
  Raster<double> impulse(128, 128);
  impulse.at(3, 7) = 1.0;
  const Raster<double> filtered = idealLowPass(128, 128, 8.0)({impulse})[0];
  CHECK(filtered.at(3, 7) == doctest::Approx(197.0 / (128.0 * 128.0)));
}

TEST_CASE("the windowed sinc has unit gain, is positive and ends after one period") {
  constexpr double kPeriod = 6.0;
  Raster<double> impulse(64, 48);
  impulse.at(2, 20) = 1.0;
  for (const bool wrap : {false, true}) {
    const Raster<double> filtered = sincLowPass(64, 48, kPeriod, wrap, wrap)({impulse})[0];
    double sum = 0.0;
    for (int y = 0; y < 48; ++y) {
      for (int x = 0; x < 64; ++x) {
        const int across = std::min(std::abs(x - 2), 64 - std::abs(x - 2)), dx = wrap ? across : std::abs(x - 2);
        const double distance = std::hypot(dx, y - 20);
        sum += filtered.at(x, y);
        CHECK(filtered.at(x, y) > -1e-15);
        if (distance >= kPeriod) CHECK(std::abs(filtered.at(x, y)) < 1e-15);
        if (distance < kPeriod - 1.0) CHECK(filtered.at(x, y) > 1e-5);
      }
    }
    if (wrap) CHECK(sum == doctest::Approx(1.0));
    if (!wrap) CHECK(sum < 0.95);  // the rest fell off the edge
  }
}

}  // namespace parhelion
