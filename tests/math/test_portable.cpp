// SPDX-License-Identifier: Apache-2.0
#include "math/portable.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include "math/conventions.h"
#include "math/turn.h"
#include "random_stream.h"

using namespace parhelion;

namespace {

constexpr int kArguments = 20000;

/// Distance of `x` from `truth` in units of the last place of `truth`.
double ulps(double x, long double truth) {
  const double rounded = std::abs(static_cast<double>(truth));
  const double ulp = std::max(std::nextafter(rounded, HUGE_VAL) - rounded, std::numeric_limits<double>::denorm_min());
  return static_cast<double>(std::abs(x - truth) / ulp);
}

/// The worst error of `function` against `truth` over arguments of both signs from 10^-12 to `largest`, evenly spread
/// over their logarithm.
template <class Function, class Truth>
double worstUlps(const Function& function, const Truth& truth, double largest) {
  RandomStream random(5, 0, RandomPurpose::path);
  double worst = 0.0;
  for (int i = 0; i < kArguments; ++i) {
    const double magnitude = std::pow(10.0, -12.0 + (12.0 + std::log10(largest)) * random.next());
    for (const double x : {magnitude, -magnitude})
      worst = std::max(worst, ulps(function(x), truth(static_cast<long double>(x))));
  }
  return worst;
}

}  // namespace

TEST_CASE("portable sines, cosines and tangents are within 2 ulp of the C library's long double, up to 1e9") {
  CHECK(worstUlps(
            portable::sin, [](long double x) { return std::sin(x); }, 1e9) < 2.0);
  CHECK(worstUlps(
            portable::cos, [](long double x) { return std::cos(x); }, 1e9) < 2.0);
  CHECK(worstUlps(
            portable::tan, [](long double x) { return std::tan(x); }, 1e9) < 2.0);
  CHECK(worstUlps([](double x) { return portable::sincos(x).sin; }, [](long double x) { return std::sin(x); }, 1e9) <
        2.0);
  CHECK(worstUlps([](double x) { return portable::sincos(x).cos; }, [](long double x) { return std::cos(x); }, 1e9) <
        2.0);
}

TEST_CASE("portable sine is exact to 2 ulp beside the multiples of pi / 2") {
  for (int k = -200; k <= 200; ++k) {
    const double x = k * (0.5 * kPi);
    CHECK(ulps(portable::sin(x), std::sin(static_cast<long double>(x))) < 2.0);
    CHECK(ulps(portable::cos(x), std::cos(static_cast<long double>(x))) < 2.0);
  }
}

TEST_CASE("portable exponentials and logarithms are within 2 ulp of the C library's long double") {
  CHECK(worstUlps(
            portable::exp, [](long double x) { return std::exp(x); }, 700.0) < 2.0);
  CHECK(worstUlps([](double x) { return portable::log(std::abs(x)); },
                  [](long double x) { return std::log(std::abs(x)); }, 1e300) < 2.0);
  CHECK(portable::exp(0.0) == 1.0);
  CHECK(portable::log(1.0) == 0.0);
}

TEST_CASE("portable atan2 is within 2 ulp of the C library's long double in every quadrant") {
  RandomStream random(6, 0, RandomPurpose::path);
  double worst = 0.0;
  for (int i = 0; i < kArguments; ++i) {
    const double y = (random.next() - 0.5) * std::pow(10.0, 16.0 * (random.next() - 0.5));
    const double x = (random.next() - 0.5) * std::pow(10.0, 16.0 * (random.next() - 0.5));
    worst = std::max(worst, ulps(portable::atan2(y, x), std::atan2(static_cast<long double>(y), x)));
  }
  CHECK(worst < 2.0);
  CHECK(portable::atan2(0.0, 1.0) == 0.0);
  CHECK(portable::atan2(0.0, -1.0) == kPi);
  CHECK(portable::atan2(1.0, 0.0) == 0.5 * kPi);
}

TEST_CASE("sine and cosine of a share of a turn are right to their last digits, also where one of them vanishes") {
  const auto check = [](double turn) {
    const long double angle = 2.0L * std::acos(-1.0L) * static_cast<long double>(turn);
    const auto [s, c] = sincosOfTurnOf(turn);
    REQUIRE(std::abs(static_cast<double>(s - std::sin(angle))) < 3e-16);
    REQUIRE(std::abs(static_cast<double>(c - std::cos(angle))) < 3e-16);
  };
  RandomStream random(7, 0, RandomPurpose::path);
  for (int i = 0; i < 100 * kArguments; ++i) check(random.next());
  for (int i = 0; i <= 16; ++i)
    for (const double turn : {i / 16.0, std::nextafter(i / 16.0, 0.0), std::nextafter(i / 16.0, 1.0)}) check(turn);
  CHECK(sincosOfTurnOf(0.0).sin == 0.0);
  CHECK(sincosOfTurnOf(0.25).sin == 1.0);
  CHECK(sincosOfTurnOf(0.5).cos == -1.0);
  CHECK(sincosOfTurnOf(1.0).cos == 1.0);
}
