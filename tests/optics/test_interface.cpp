// SPDX-License-Identifier: Apache-2.0
#include "optics/interface.h"

#include <cmath>
#include <initializer_list>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "math/random.h"

using namespace parhelion;

namespace {

constexpr double kIndex = 1.31;

/// Angles of incidence from 0 to 90 degrees, ends included.
template <class Test>
void forAnglesOfIncidence(const Test& test) {
  constexpr int kSteps = 900;
  for (int i = 0; i <= kSteps; ++i) test(0.5 * kPi * i / kSteps);
}

}  // namespace

TEST_CASE("at normal incidence ((n - 1) / (n + 1))^2 is reflected") {
  for (const double n : {1.31, 1.0 / 1.31, 1.5, 2.4}) {
    const double r = (n - 1.0) / (n + 1.0);
    CHECK(fresnel<double>(1.0, n).reflectance == doctest::Approx(r * r).epsilon(1e-13));
    CHECK(fresnel<double>(1.0, n).cosTheta_t == doctest::Approx(1.0).epsilon(1e-15));
  }
}

TEST_CASE("at Brewster's angle only the s polarisation is reflected") {
  for (const double n : {1.31, 1.0 / 1.31}) {
    const double theta_i = std::atan(n), theta_t = 0.5 * kPi - theta_i;
    // Fresnel's sine law for s; p is none.
    const double s = std::sin(theta_i - theta_t) / std::sin(theta_i + theta_t);
    CHECK(fresnel<double>(std::cos(theta_i), n).reflectance == doctest::Approx(0.5 * s * s).epsilon(1e-13));
  }
}

TEST_CASE("reflectance is the mean of Fresnel's sine and tangent laws") {
  forAnglesOfIncidence([](double theta_i) {
    if (theta_i < 0.01 || theta_i > 1.56) return;  // where these forms lose their digits
    const double theta_t = std::asin(std::sin(theta_i) / kIndex);
    const double s = std::sin(theta_i - theta_t) / std::sin(theta_i + theta_t);
    const double p = std::tan(theta_i - theta_t) / std::tan(theta_i + theta_t);
    CHECK(fresnel<double>(std::cos(theta_i), kIndex).reflectance ==
          doctest::Approx(0.5 * (s * s + p * p)).epsilon(1e-10));
  });
}

TEST_CASE("what is not reflected is transmitted") {
  forAnglesOfIncidence([](double theta_i) {
    const double c = std::cos(theta_i);
    const auto [reflectance, t] = fresnel<double>(c, kIndex);
    // Transmitted amplitudes and the widths of the beams. Born & Wolf, section 1.5.3.
    const double s = 2.0 * c / (c + kIndex * t), p = 2.0 * c / (kIndex * c + t);
    const double transmittance = c > 0.0 ? kIndex * t / c * 0.5 * (s * s + p * p) : 0.0;
    CHECK(std::abs(reflectance + transmittance - 1.0) < 1e-14);
  });
}

TEST_CASE("a path reflects as much from within as from without") {
  forAnglesOfIncidence([](double theta_i) {
    const auto [outside, cosTheta_t] = fresnel<double>(std::cos(theta_i), kIndex);
    const auto [inside, cosBack] = fresnel<double>(cosTheta_t, 1.0 / kIndex);
    // The way back amplifies a rounding of cosTheta_t by the slope of R, without bound toward 90 degrees.
    const double grazing = std::fmax(std::cos(theta_i), 1e-8);
    CHECK(std::abs(inside - outside) < 1e-14 / grazing);
    CHECK(std::abs(cosBack - std::cos(theta_i)) < 1e-14 / grazing);
  });
}

TEST_CASE("around the critical angle reflectance is finite, at most 1, and rises to 1") {
  // 1 - R = 2 (n + 1 / n) sqrt(2 step) / sqrt(1 - 1 / n^2) to first order, for sin(theta_i) = (1 - step) / n.
  const double slope = 2.0 * (kIndex + 1.0 / kIndex) * std::sqrt(2.0) / std::sqrt(1.0 - 1.0 / (kIndex * kIndex));
  const auto inside = [](double sine) {
    return fresnel<double>(std::sqrt((1.0 - sine) * (1.0 + sine)), 1.0 / kIndex).reflectance;
  };
  for (int k = 3; k <= 16; ++k) {
    INFO("k = " << k);
    const double step = std::pow(10.0, -k);
    const double below = inside((1.0 - step) / kIndex), above = inside((1.0 + step) / kIndex);
    // From k = 15 on the sine itself is rounded across the critical angle.
    const double rounding = 4e-16;
    for (const double reflectance : {below, above}) {
      CHECK(reflectance <= 1.0);
      CHECK(1.0 - reflectance < 1.01 * slope * std::sqrt(step + rounding));
    }
    if (k < 15) {
      CHECK((1.0 - below) / (slope * std::sqrt(step)) ==
            doctest::Approx(1.0).epsilon(20.0 * std::sqrt(step) + rounding / step));
      CHECK(above == 1.0);
    }
  }
}

TEST_CASE("at grazing incidence reflectance tends to 1 without loss of digits") {
  // 1 - R = 2 (n^2 + 1) / sqrt(n^2 - 1) c to first order in the cosine c.
  const double slope = 2.0 * (kIndex * kIndex + 1.0) / std::sqrt(kIndex * kIndex - 1.0);
  for (int k = 3; k <= 9; ++k) {
    const double c = std::pow(10.0, -k), reflectance = fresnel<double>(c, kIndex).reflectance;
    CHECK(reflectance < 1.0);
    CHECK((1.0 - reflectance) / (slope * c) == doctest::Approx(1.0).epsilon(20.0 * c + 1e-15 / c));
  }
  for (const double c : {1e-15, 1e-300, 0.0}) {
    CHECK(fresnel<double>(c, kIndex).reflectance <= 1.0);
    CHECK(fresnel<double>(c, kIndex).reflectance > 1.0 - 1e-13);
    CHECK(fresnel<double>(c, 1.0 / kIndex).reflectance == 1.0);
  }
}

TEST_CASE("light falling from everywhere on a crystal of any convex shape is reflected by 6.274 per cent") {
  // The mean over random orientations of a convex body: the integral of 2 mu R(mu) over mu.
  constexpr int kSteps = 200000;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double mu = (i + 0.5) / kSteps;
    sum += 2.0 * mu * fresnel<double>(mu, kIndex).reflectance / kSteps;
  }
  const double n = kIndex, n2 = n * n, n4 = n2 * n2;
  const double closed = 0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
                        n2 * (n2 - 1) * (n2 - 1) / std::pow(n2 + 1, 3) * std::log((n - 1) / (n + 1)) -
                        2 * n2 * n * (n2 + 2 * n - 1) / ((n2 + 1) * (n4 - 1)) +
                        8 * n4 * (n4 + 1) / ((n2 + 1) * (n4 - 1) * (n4 - 1)) * std::log(n);
  CHECK(std::abs(sum - closed) < 1e-9);
  CHECK(std::abs(sum - 0.0627420) < 5e-8);
}

TEST_CASE("the index 1 neither reflects nor bends") {
  forAnglesOfIncidence([](double theta_i) {
    if (theta_i >= 0.5 * kPi) return;
    const double c = std::cos(theta_i);
    CHECK(fresnel<double>(c, 1.0).reflectance < 1e-30);
    CHECK(fresnel<double>(c, 1.0).cosTheta_t == doctest::Approx(c).epsilon(1e-15));
  });
}
