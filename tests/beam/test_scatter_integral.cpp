// SPDX-License-Identifier: Apache-2.0
// Light over the scattering angle, integrated, against closed forms and against rays.
#include <cmath>
#include <random>

#include <doctest/doctest.h>

#include "beam/angle_bins.h"
#include "beam/scatter_integral.h"
#include "halos/experiment.h"
#include "parallel/threads.h"
#include "statistics.h"
#include "trace/scatter_profile.h"

using namespace parhelion;

namespace {

ScatterScene randomPrisms(double aspect, double index) {
  return {PrismSection(), {{2.0 * aspect, 1.0}}, IceLight({{index, 1.0}})};
}

ScatterAccuracy accuracyOf(double error, bool detailed = false) {
  ScatterAccuracy accuracy;
  accuracy.error = error;
  accuracy.detailed = detailed;
  return accuracy;
}

/// Light reflected at the outside of randomly oriented convex crystals; physics of Fresnel's mean over a hemisphere.
double externalShare(double n) {
  const double m = n * n;
  return 0.5 + (n - 1.0) * (3.0 * n + 1.0) / (6.0 * (n + 1.0) * (n + 1.0)) +
         m * (m - 1.0) * (m - 1.0) / std::pow(m + 1.0, 3.0) * std::log((n - 1.0) / (n + 1.0)) -
         2.0 * n * m * (m + 2.0 * n - 1.0) / ((m + 1.0) * (m * m - 1.0)) +
         8.0 * m * m * (m * m + 1.0) / ((m + 1.0) * std::pow(m * m - 1.0, 2.0)) * std::log(n);
}

/// Chi-square over its degrees of freedom of the integral against rays, in bins of half a degree; counts errors of
/// both.
double chiSquareAgainstRays(double aspect, double index, double error) {
  constexpr int kBins = 360;
  const ScatterIntegral integral = integrateScatter(randomPrisms(aspect, index), accuracyOf(error), kBins, 0.0, kPi);
  ScatterProfile rays(kBins, 0.0, kPi);
  traceRays(cloudUnderPointSun(0.3, {prisms(aspect, RandomOrientation{})}, ConstantIndex{index}),
            {.rays = 1'000'000, .seed = 7}, 0, rays);
  const auto bins = rays.bins();
  double sum = 0.0;
  for (std::size_t k = 0; k < kBins; ++k) {
    const double light = integral.light[k] + (k == 0 ? integral.totals.undeviated : 0.0);
    const double square = bins[k].error * bins[k].error + integral.error[k] * integral.error[k];
    sum += (light - bins[k].energy) * (light - bins[k].energy) / square;
  }
  return sum / kBins;
}

}  // namespace

TEST_CASE("triangles of light keep all of it, and put it where it is") {
  AngleBins bins(100, 0.0, 1.0);
  const double angle[3] = {0.31, 0.12, 0.62}, density[3] = {1.0, 3.0, 2.0};
  bins.addTriangle(angle, density);
  double sum = 0.0, first = 0.0;
  for (std::size_t k = 0; k < 100; ++k) {
    sum += bins.light()[k];
    first += bins.light()[k] * (static_cast<double>(k) + 0.5) / 100.0;
    CHECK(bins.light()[k] > -1e-15);
  }
  CHECK(sum == doctest::Approx(2.0).epsilon(1e-13));
  // The mean of a product of two linear functions over a triangle.
  double product = 0.0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) product += angle[i] * density[j] * (i == j ? 2.0 : 1.0) / 12.0;
  CHECK(first == doctest::Approx(product).epsilon(1e-4));

  // Outside the bins, in one bin, at both ends.
  AngleBins few(2, 0.2, 0.4);
  few.addTriangle(angle, density);
  double inside = 0.0;
  for (std::size_t k = 20; k < 40; ++k) inside += bins.light()[k];
  CHECK(few.light()[0] + few.light()[1] == doctest::Approx(inside).epsilon(1e-13));
  const double same[3] = {0.3, 0.3, 0.3}, ends[3] = {0.4, 0.4, 0.4}, beyond[3] = {0.5, 0.6, 0.7};
  for (const double* all : {same, ends, beyond}) few.addTriangle(all, density);
  CHECK(few.light()[0] + few.light()[1] == doctest::Approx(inside + 4.0).epsilon(1e-13));
}

TEST_CASE("integrated light of random prisms meets its closed forms") {
  for (const double aspect : {0.3, 1.0, 3.0}) {
    CAPTURE(aspect);
    const ScatterIntegral integral =
        integrateScatter(randomPrisms(aspect, 1.31), accuracyOf(5e-3, true), 180, 0.0, kPi);
    CHECK(integral.totals.external == doctest::Approx(externalShare(1.31)).epsilon(1e-6));
    CHECK(integral.totals.intercepted == doctest::Approx(1.0).epsilon(1e-7));  // Cauchy
    const double volume = 3.0 * std::sqrt(3.0) * aspect, surface = 12.0 * aspect + 3.0 * std::sqrt(3.0);
    CHECK(std::abs(integral.totals.path - 1.31 * 1.31 * 4.0 * volume / surface) < 4.0 * integral.pathError + 1e-4);
    double sum = integral.totals.undeviated + integral.totals.cutOff;
    for (const double light : integral.light) sum += light;
    CHECK(sum == doctest::Approx(1.0).epsilon(3e-4));
  }
  CHECK(externalShare(1.31) == doctest::Approx(0.0627420).epsilon(1e-6));
}

TEST_CASE("indices from 1.01 to 3 are integrated without loss, and reflect what they must at the outside") {
  for (const double index : {1.01, 1.2, 1.5, 2.0, 3.0}) {
    CAPTURE(index);
    const ScatterIntegral integral = integrateScatter(randomPrisms(0.5, index), accuracyOf(2e-2, true), 180, 0.0, kPi);
    CHECK(integral.totals.external == doctest::Approx(externalShare(index)).epsilon(1e-5));
    double sum = integral.totals.undeviated + integral.totals.cutOff;
    for (const double light : integral.light) sum += light;
    CHECK(sum == doctest::Approx(1.0).epsilon(1e-3));
    CHECK(integral.totals.cutOff < 1e-5);
  }
}

TEST_CASE("prisms whose sides differ reflect as much outside as all others, and lose nothing") {
  const ScatterScene scene{PrismSection({0.8, 0.9, 0.75, 0.85, 0.95, 0.7}), {{2.0, 1.0}}, IceLight({{1.31, 1.0}})};
  const ScatterIntegral integral = integrateScatter(scene, accuracyOf(0.05), 90, 0.0, kPi);
  CHECK(integral.totals.external == doctest::Approx(externalShare(1.31)).epsilon(1e-5));
  CHECK(integral.totals.intercepted == doctest::Approx(1.0).epsilon(1e-6));
  double sum = integral.totals.undeviated + integral.totals.cutOff;
  for (const double light : integral.light) sum += light;
  CHECK(sum == doctest::Approx(1.0).epsilon(1e-3));
}

TEST_CASE("the integral is what rays find, of thin plates and long columns, of weak and strong refraction") {
  for (const double aspect : {0.05, 0.3, 1.0, 3.0, 20.0}) {
    CAPTURE(aspect);
    for (const double index : {1.2, 1.31, 1.45}) {
      CAPTURE(index);
      const double chiSquare = chiSquareAgainstRays(aspect, index, 0.01);
      CHECK(chiSquare > 0.7);
      CHECK(chiSquare < 1.3);  // four standard deviations of 360 degrees of freedom
    }
  }
}

TEST_CASE("the rings' edges are in their bin of 0.01 degrees, of weak and strong refraction") {
  constexpr double kHalfWidth = 0.2;
  constexpr int kBins = 40;
  for (const auto& [aspect, index] : {std::pair(1.0, 1.31), {0.3, 1.31}, {3.0, 1.31}, {1.0, 1.2}, {1.0, 1.45}})
    for (const double wedge : {60.0, 90.0}) {
      CAPTURE(aspect);
      CAPTURE(index);
      CAPTURE(wedge);
      const double sine = index * std::sin(radians(0.5 * wedge));
      if (sine >= 1.0) continue;                                   // no light gets through
      const double edge = 2.0 * std::asin(sine) - radians(wedge);  // least deviation
      const ScatterIntegral integral = integrateScatter(randomPrisms(aspect, index), accuracyOf(0.02), kBins,
                                                        edge - radians(kHalfWidth), edge + radians(kHalfWidth));
      // The step lies where light has risen half-way from before to behind, within one bin.
      const double before = integral.light[15], behind = integral.light[24];
      int risen = 0;
      while (integral.light[static_cast<std::size_t>(risen)] < 0.5 * (before + behind)) ++risen;
      CHECK(std::abs(risen - 20) <= 1);
      CHECK(behind > 1.2 * before);
    }
}

TEST_CASE("light that comes straight back is as bright as rays have it") {
  // Beside 180 degrees the angle is a cone over the directions: linear between nodes it would never be 180.
  constexpr int kBins = 1800;
  constexpr std::size_t kLast = 3;
  const ScatterIntegral integral = integrateScatter(randomPrisms(1.0, 1.31), accuracyOf(0.03), kBins, 0.0, kPi);
  ScatterProfile rays(kLast, kPi * (kBins - int{kLast}) / kBins, kPi);
  traceRays(cloudUnderPointSun(0.3, {prisms(1.0, RandomOrientation{})}, ConstantIndex{1.31}),
            {.rays = 6'000'000, .seed = 11}, 0, rays);
  double light = 0.0, energy = 0.0, square = 0.0;
  for (std::size_t k = 0; k < kLast; ++k) {
    light += integral.light[kBins - kLast + k];
    energy += rays.bins()[k].energy;
    square += rays.bins()[k].error * rays.bins()[k].error;
  }
  CHECK(std::sqrt(square) < 0.015 * energy);
  CHECK(std::abs(light - energy) < kSigmas * std::sqrt(square) + 0.02 * energy);
}

TEST_CASE("the bits of an integral do not depend on threads") {
  const auto of = [](int threads) {
    return withThreads(threads,
                       [] { return integrateScatter(randomPrisms(0.7, 1.31), accuracyOf(0.02), 90, 0.0, kPi); });
  };
  const ScatterIntegral one = of(1);
  for (const int threads : {2, 7}) {
    const ScatterIntegral other = of(threads);
    CHECK(one.light == other.light);
    CHECK(one.error == other.error);
    CHECK(one.totals.cosine == other.totals.cosine);
  }
}

TEST_CASE("stated errors of bins hold against a finer integral") {
  constexpr int kBins = 900;
  const ScatterIntegral fine = integrateScatter(randomPrisms(1.7, 1.31), accuracyOf(3e-3), kBins, 0.0, kPi);
  const ScatterIntegral rough = integrateScatter(randomPrisms(1.7, 1.31), accuracyOf(2e-2), kBins, 0.0, kPi);
  int within[3] = {};
  for (std::size_t k = 0; k < kBins; ++k)
    for (int sigma = 1; sigma <= 3; ++sigma)
      within[sigma - 1] += std::abs(rough.light[k] - fine.light[k]) <= sigma * rough.error[k];
  CHECK(within[0] >= 0.60 * kBins);
  CHECK(within[1] >= 0.90 * kBins);
  CHECK(within[2] >= 0.98 * kBins);
}

TEST_CASE("a spectrum's integral lies between those of its ends, and its ring is as wide as they are apart") {
  std::vector<double> indices;
  for (int k = 0; k <= 64; ++k) indices.push_back(1.316 - 0.008 * k / 64.0);
  const ScatterScene scene{PrismSection(), {{2.0, 1.0}}, IceLight::continuous(indices)};
  const ScatterIntegral integral = integrateScatter(scene, accuracyOf(0.05), 300, radians(20.0), radians(23.0));
  // Least deviations at both ends of the spectrum, between which light rises.
  const double first = 2.0 * std::asin(1.308 * 0.5) - kPi / 3.0, last = 2.0 * std::asin(1.316 * 0.5) - kPi / 3.0;
  const auto at = [&](double angle) {
    return integral.light[static_cast<std::size_t>((degrees(angle) - 20.0) * 100.0)];
  };
  const double before = at(first - radians(0.1)), middle = at(0.5 * (first + last)), behind = at(last + radians(0.1));
  CHECK(middle > before + 0.3 * (behind - before));
  CHECK(middle < before + 0.7 * (behind - before));
  CHECK_THROWS_AS(IceLight(std::vector<IndexShare>{}), std::invalid_argument);
}
