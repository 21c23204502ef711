// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "crystal/orientation.h"
#include "random_stream.h"
#include "statistics.h"

using namespace parhelion;

namespace {

constexpr int kDraws = 200000;
constexpr double kFree = std::numeric_limits<double>::infinity();

struct Example {
  std::string name;
  ValueSampler sampler;
  double lo, hi;                               // where all but 1e-15 of the weight lies
  std::function<double(double)> unnormalised;  // the density as population_settings.h writes it
};

ValueSampler zenith(const AngleDistribution& d) { return {d, DensityPer::solidAngle, -kFree, kFree}; }
ValueSampler fromZenith(const AngleDistribution& d) { return {d, DensityPer::solidAngle, 0.0, kFree}; }
ValueSampler plain(const AngleDistribution& d) { return {d, DensityPer::unit, -kFree, kFree}; }

std::function<double(double)> gauss(double mean, double sigma, bool perSolidAngle = false) {
  return [=](double x) {
    return std::exp(-0.5 * (x - mean) * (x - mean) / (sigma * sigma)) * (perSolidAngle ? std::abs(std::sin(x)) : 1.0);
  };
}
std::function<double(double)> laplace(double mean, double scale) {
  return [=](double x) { return std::exp(-std::abs(x - mean) / scale); };
}

const std::vector<Example>& examples() {
  const double right = 0.5 * kPi, one = radians(1.0), wide = radians(40.0);
  static const std::vector<Example> all = {
      {"uniform", plain(UniformRange{-1.0, 3.0}), -1.0, 3.0, [](double) { return 1.0; }},
      {"normal roll", plain(Normal{2.0, one}), 2.0 - 8 * one, 2.0 + 8 * one, gauss(2.0, one)},
      {"normal about the zenith", fromZenith(Normal{0.0, one}), 0.0, 8 * one, gauss(0.0, one, true)},
      {"normal about the horizon", zenith(Normal{right, one}), right - 8 * one, right + 8 * one,
       gauss(right, one, true)},
      {"normal about the nadir", zenith(Normal{kPi, one}), kPi - 8 * one, kPi + 8 * one, gauss(kPi, one, true)},
      {"wide normal about the zenith", fromZenith(Normal{0.0, wide}), 0.0, 8 * wide, gauss(0.0, wide, true)},
      {"wide normal aside", zenith(Normal{radians(60), wide}), radians(60) - 8 * wide, radians(60) + 8 * wide,
       gauss(radians(60), wide, true)},
      {"polar normal about the zenith", fromZenith(PolarNormal{0.0, one}), 0.0, 8 * one, gauss(0.0, one)},
      {"polar normal about the horizon", zenith(PolarNormal{right, wide}), right - 8 * wide, right + 8 * wide,
       gauss(right, wide)},
      {"laplace about the zenith", fromZenith(Laplace{0.0, one}), 0.0, 36 * one, laplace(0.0, one)},
      {"laplace about the horizon", zenith(Laplace{right, one}), right - 36 * one, right + 36 * one,
       laplace(right, one)},
      {"laplace through both poles", zenith(Laplace{radians(20), wide}), radians(20) - 36 * wide,
       radians(20) + 36 * wide, laplace(radians(20), wide)},
      {"normal aspect", ValueSampler(Normal{0.5, 0.4}, DensityPer::unit, 1e-4, 1e4), 1e-4, 0.5 + 8 * 0.4,
       gauss(0.5, 0.4)}};
  return all;
}

std::vector<double> draw(const ValueSampler& sampler) {
  RandomStream random(31, 0, RandomPurpose::path);
  std::vector<double> samples;
  for (int i = 0; i < kDraws; ++i) samples.push_back(sampler.sample(random.next()));
  return samples;
}

/// The mean square distance of a sampler's values from `centre`.
SampleMean meanSquare(const ValueSampler& sampler, double centre) {
  SampleMean mean;
  for (const double x : draw(sampler)) mean.add((x - centre) * (x - centre));
  return mean;
}

}  // namespace

TEST_CASE("every distribution's samples follow its own density") {
  for (const Example& e : examples()) {
    INFO(e.name);
    const auto cumulative = cumulativeOf([&](double x) { return e.sampler.density(x); }, e.lo, e.hi);
    CHECK(chiSquareSigma(draw(e.sampler), cumulative, e.lo, e.hi, 200) < kSigmas);
  }
}

TEST_CASE("every distribution's samples follow its formula") {
  for (const Example& e : examples()) {
    INFO(e.name);
    CHECK(chiSquareSigma(draw(e.sampler), cumulativeOf(e.unnormalised, e.lo, e.hi), e.lo, e.hi, 200) < kSigmas);
  }
}

TEST_CASE("every density integrates to 1 and is in proportion to its formula") {
  for (const Example& e : examples()) {
    INFO(e.name);
    constexpr int kSteps = 100000;
    double sum = 0.0, formula = 0.0, highest = 0.0;
    for (int i = 0; i < kSteps; ++i) {
      const double x = e.lo + (e.hi - e.lo) * (i + 0.5) / kSteps;
      sum += e.sampler.density(x) * (e.hi - e.lo) / kSteps;
      formula += e.unnormalised(x) * (e.hi - e.lo) / kSteps;
      highest = std::max(highest, e.unnormalised(x));
    }
    CHECK(sum == doctest::Approx(1.0).epsilon(1e-5));
    const double peak = highest / formula;
    for (const double u : {0.01, 0.2, 0.5, 0.7, 0.99}) {
      const double x = e.sampler.sample(u);
      // The chords of 4096 cells: up to 3e-4 of the peak at a Laplace's tip that is not at a node.
      CHECK(std::abs(e.sampler.density(x) - e.unnormalised(x) / formula) < 3e-4 * peak);
    }
  }
}

TEST_CASE("a fluttering angle follows the arcsine law") {
  const double mean = 0.3, amplitude = 0.1;
  const ValueSampler sampler = plain(Arcsine{mean, amplitude});
  const auto cumulative = [&](double x) {
    return 0.5 + std::asin(std::clamp((x - mean) / amplitude, -1.0, 1.0)) / kPi;
  };
  CHECK(chiSquareSigma(draw(sampler), cumulative, mean - amplitude, mean + amplitude, 200) < kSigmas);
  for (const double x : {0.21, 0.25, 0.3, 0.38})
    CHECK(sampler.density(x) == doctest::Approx((cumulative(x + 1e-6) - cumulative(x - 1e-6)) / 2e-6).epsilon(1e-6));
  CHECK(sampler.density(0.19) == 0.0);
  CHECK(sampler.density(0.41) == 0.0);
  CHECK(meanSquare(sampler, mean).sigmasFrom(0.5 * amplitude * amplitude) < kSigmas);
}

TEST_CASE("tilts about the vertical: a normal per solid angle has <t^2> = 2 sigma^2, in the polar angle sigma^2") {
  const double sigma = radians(1.0);
  // sin t for t costs the first a share of 2e-4 or less, a tenth of the standard error.
  CHECK(meanSquare(zenith(Normal{0.0, sigma}), 0.0).sigmasFrom(2.0 * sigma * sigma) < kSigmas);
  CHECK(meanSquare(zenith(Normal{kPi, sigma}), kPi).sigmasFrom(2.0 * sigma * sigma) < kSigmas);
  CHECK(meanSquare(zenith(PolarNormal{0.0, sigma}), 0.0).sigmasFrom(sigma * sigma) < kSigmas);
  CHECK(meanSquare(zenith(Laplace{0.0, sigma}), 0.0).sigmasFrom(2.0 * sigma * sigma) < kSigmas);
}

TEST_CASE("tilts about the horizon: both normals have <t^2> = sigma^2") {
  const double sigma = radians(1.0), right = 0.5 * kPi;
  CHECK(meanSquare(zenith(Normal{right, sigma}), right).sigmasFrom(sigma * sigma) < kSigmas);
  CHECK(meanSquare(zenith(PolarNormal{right, sigma}), right).sigmasFrom(sigma * sigma) < kSigmas);
  CHECK(meanSquare(zenith(Laplace{right, sigma}), right).sigmasFrom(2.0 * sigma * sigma) < kSigmas);
}

TEST_CASE("distributions without width give their mean") {
  for (const AngleDistribution& d :
       std::initializer_list<AngleDistribution>{FixedValue{0.7}, UniformRange{0.7, 0.7}, Normal{0.7, 0.0},
                                                PolarNormal{0.7, 0.0}, Arcsine{0.7, 0.0}, Laplace{0.7, 0.0}})
    for (const double u : {0x1p-53, 0.3, 1.0 - 0x1p-53}) {
      CHECK(zenith(d).sample(u) == doctest::Approx(0.7).epsilon(1e-15));
      CHECK(zenith(d).density(0.6) == 0.0);
    }
  CHECK(zenith(FixedValue{0.7}).density(0.7) == kFree);
}

TEST_CASE("samples stay finite and in range at the ends of the unit interval") {
  for (const Example& e : examples()) {
    INFO(e.name);
    for (const double u : {0x1p-53, 1.0 - 0x1p-53}) {
      CHECK(e.sampler.sample(u) >= e.lo - 1e-12);
      CHECK(e.sampler.sample(u) <= e.hi + 1e-12);
    }
  }
}

TEST_CASE("a distribution that lies wholly outside its range is rejected") {
  CHECK_THROWS_AS(fromZenith(Normal{-5.0, 0.1}), std::invalid_argument);
  CHECK_THROWS_AS(fromZenith(Laplace{-5.0, 0.1}), std::invalid_argument);
  CHECK_THROWS_AS(zenith(PolarNormal{NAN, 0.1}), std::invalid_argument);
  CHECK_THROWS_AS(ValueSampler(Normal{-3.0, 0.1}, DensityPer::unit, 1e-4, 1e4), std::invalid_argument);
}
