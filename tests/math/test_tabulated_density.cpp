// SPDX-License-Identifier: Apache-2.0
#include "math/tabulated_density.h"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "random_stream.h"
#include "statistics.h"

using namespace parhelion;

namespace {

struct Example {
  std::string name;
  TabulatedDensity density;
  double lo, hi;
};

/// Smooth, narrow, zero in the middle, zero at the ends, and a single cell.
const std::vector<Example>& examples() {
  static const std::vector<Example> all = {
      {"bell", {[](double x) { return std::exp(-0.5 * x * x); }, -8.0, 8.0, 4096}, -8.0, 8.0},
      {"needle", {[](double x) { return std::exp(-1e4 * (x - 2) * (x - 2)); }, 0.0, 10.0, 5000}, 0.0, 10.0},
      {"gap", {[](double x) { return x < 1.0 || x > 2.0 ? 3.0 : 0.0; }, 0.0, 3.0, 30}, 0.0, 3.0},
      {"sine", {[](double x) { return std::sin(x); }, 0.0, 3.0, 100}, 0.0, 3.0},
      {"ramp", {[](double x) { return 2.0 - x; }, 1.0, 2.0, 1}, 1.0, 2.0}};
  return all;
}

}  // namespace

TEST_CASE("a tabulated density integrates to 1") {
  for (const Example& e : examples()) {
    INFO(e.name);
    // The midpoint rule is exact for linear pieces whose nodes fall between the points: 30,000 divides all the tables
    // but the two finest, and is fine enough for those.
    constexpr int kSteps = 300000;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) sum += e.density.density(e.lo + (i + 0.5) / kSteps * (e.hi - e.lo));
    CHECK(sum * (e.hi - e.lo) / kSteps == doctest::Approx(1.0).epsilon(1e-6));
  }
}

TEST_CASE("sampling inverts the cumulative distribution") {
  for (const Example& e : examples()) {
    INFO(e.name);
    const double width = e.hi - e.lo;
    for (int i = 0; i <= 10000; ++i) {
      const double u = i / 10000.0;
      CHECK(std::abs(e.density.cumulative(e.density.sample(u)) - u) < 1e-13);
      // Back from the value: wherever the density lets a rounding of u move it by less than 1e-9 of the range.
      const double x = e.lo + u * width;
      if (e.density.density(x) * width > 1e-4)
        CHECK(std::abs(e.density.sample(e.density.cumulative(x)) - x) < 1e-9 * width);
    }
  }
}

TEST_CASE("samples never leave the range, and their order is that of their quantiles") {
  for (const Example& e : examples()) {
    INFO(e.name);
    double last = e.lo;
    for (const double u : {0.0, 1e-300, 0x1p-53, 1e-9, 0.3, 0.5, 0.9, 1.0 - 1e-9, 1.0 - 0x1p-53, 1.0}) {
      const double x = e.density.sample(u);
      CHECK(x >= last);
      CHECK(x <= e.hi);
      last = x;
    }
  }
  const TabulatedDensity ramp([](double x) { return x; }, 0.0, 1.0, 10);
  CHECK(ramp.sample(0.0) == 0.0);
  CHECK(ramp.sample(1.0) == doctest::Approx(1.0).epsilon(1e-15));
}

TEST_CASE("samples of a tabulated density follow it") {
  for (const Example& e : examples()) {
    INFO(e.name);
    RandomStream random(2, 0, RandomPurpose::path);
    std::vector<double> samples;
    for (int i = 0; i < 200000; ++i) samples.push_back(e.density.sample(random.next()));
    CHECK(chiSquareSigma(
              samples, [&](double x) { return e.density.cumulative(x); }, e.lo, e.hi, 200) < kSigmas);
  }
}

TEST_CASE("a quadratic cumulative is met exactly by a linear density") {
  const TabulatedDensity ramp([](double x) { return x; }, 0.0, 4.0, 8);
  CHECK(ramp.integral() == doctest::Approx(8.0).epsilon(1e-15));
  for (const double x : {0.1, 1.0, 2.7, 3.9}) {
    CHECK(ramp.density(x) == doctest::Approx(x / 8.0).epsilon(1e-14));
    CHECK(ramp.cumulative(x) == doctest::Approx(x * x / 16.0).epsilon(1e-14));
    CHECK(ramp.sample(x * x / 16.0) == doctest::Approx(x).epsilon(1e-14));
  }
}

TEST_CASE("a tabulated density is nothing outside its range") {
  const TabulatedDensity flat([](double) { return 1.0; }, -1.0, 1.0, 4);
  CHECK(flat.density(-1.001) == 0.0);
  CHECK(flat.density(1.001) == 0.0);
  CHECK(flat.density(1.0) == 0.5);
  CHECK(flat.cumulative(-2.0) == 0.0);
  CHECK(flat.cumulative(2.0) == 1.0);
}

TEST_CASE("what is no density is rejected") {
  const auto make = [](const std::function<double(double)>& f, double lo, double hi, int cells) {
    return TabulatedDensity(f, lo, hi, cells);
  };
  const auto flat = [](double) { return 1.0; };
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(make(flat, 1.0, 1.0, 10), std::invalid_argument);
  CHECK_THROWS_AS(make(flat, 2.0, 1.0, 10), std::invalid_argument);
  CHECK_THROWS_AS(make(flat, nan, 1.0, 10), std::invalid_argument);
  CHECK_THROWS_AS(make(flat, 0.0, 1.0, 0), std::invalid_argument);
  CHECK_THROWS_AS(make([](double) { return 0.0; }, 0.0, 1.0, 10), std::invalid_argument);
  CHECK_THROWS_AS(make([](double x) { return x - 0.5; }, 0.0, 1.0, 10), std::invalid_argument);
  CHECK_THROWS_AS(make([=](double) { return nan; }, 0.0, 1.0, 10), std::invalid_argument);
  CHECK_THROWS_AS(make([=](double x) { return x == 1.0 ? inf : 1.0; }, 0.0, 1.0, 10), std::invalid_argument);
}
