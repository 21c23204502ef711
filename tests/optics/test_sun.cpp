// SPDX-License-Identifier: Apache-2.0
#include "optics/sun.h"

#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "math/rotation.h"
#include "random_stream.h"
#include "statistics.h"

using namespace parhelion;

namespace {

// Neckel & Labs 1994 at 560 nm, in powers of mu.
constexpr double kLaw[] = {0.26892, 1.34319, -1.58427, 1.91271, -1.31350, 0.37295};

/// Integral of mu^power times the law over mu from 0 to `mu`.
double moment(double mu, int power) {
  double sum = 0.0;
  for (int k = 0; k < 6; ++k) sum += kLaw[k] * std::pow(mu, k + power + 1) / (k + power + 1);
  return sum;
}

/// Share of the disc's light within `r` of its centre: r dr = -mu dmu.
double lightWithin(double r) { return 1.0 - moment(std::sqrt(1.0 - r * r), 1) / moment(1.0, 1); }

SunSettings sunAt(double elevation, double diameter) {
  SunSettings settings;
  settings.elevation = elevation;
  settings.diameter = diameter;
  return settings;
}

constexpr double kDiameter = radians(0.533);

Vec3 toPoint(const Sun& sun, double u1, double u2) {
  const auto [x, y, z] = sun.disc().toPoint(u1, u2);
  return {x, y, z};
}

}  // namespace

TEST_CASE("the sun's disc is darkened toward its limb by the law of Neckel and Labs") {
  CHECK(limbDarkening(0.0) == doctest::Approx(1.0).epsilon(1e-12));
  CHECK(limbDarkening(1.0) == doctest::Approx(0.26892).epsilon(1e-12));
  CHECK(limbDarkening(1.0 + 1e-12) == 0.0);
  for (double r = 0.0; r < 1.0; r += 0.01) CHECK(limbDarkening(r) > limbDarkening(r + 0.01));
  // At mu = 1/2, by hand.
  CHECK(limbDarkening(std::sqrt(0.75)) == doctest::Approx(0.713097).epsilon(1e-6));
}

TEST_CASE("points of the sun follow its limb darkening") {
  const Sun sun(sunAt(radians(35), kDiameter));
  std::vector<double> radii, turns;
  SampleMean squares, means;
  const Mat3 frame = frameAround(sun.toCentre());
  for (int i = 0; i < 200000; ++i) {
    RandomStream random(8, i, RandomPurpose::incidence);
    const double u1 = random.next();
    const Vec3 p = toPoint(sun, u1, random.next());
    const double r = std::sin(angleBetween(p, sun.toCentre())) / std::sin(0.5 * kDiameter);
    radii.push_back(std::min(r, 1.0));
    turns.push_back(std::atan2(glm::dot(p, frame[1]), glm::dot(p, frame[0])));
    squares.add(r * r);
    means.add(r);
    CHECK(r < 1.0 + 1e-12);
  }
  CHECK(chiSquareSigma(radii, lightWithin, 0.0, 1.0, 100) < kSigmas);
  CHECK(chiSquareSigma(
            turns, [](double t) { return t / (2.0 * kPi); }, -kPi, kPi, 100) < kSigmas);

  // <r^2> = 1 - <mu^2>; <r> is the integral of the light outside r.
  CHECK(squares.sigmasFrom(1.0 - moment(1.0, 3) / moment(1.0, 1)) < kSigmas);
  double meanRadius = 0.0;
  for (int i = 0; i < 100000; ++i) meanRadius += (1.0 - lightWithin((i + 0.5) / 100000)) / 100000;
  CHECK(means.sigmasFrom(meanRadius) < kSigmas);
}

TEST_CASE("the sun's radiance adds up to all its light, whatever the size of the disc") {
  for (const double diameter : {radians(0.01), kDiameter, radians(20), radians(120)}) {
    const Sun sun(sunAt(0.0, diameter));
    constexpr int kRings = 20000;
    double sum = 0.0;
    for (int i = 0; i < kRings; ++i) {
      const double angle = 0.5 * diameter * (i + 0.5) / kRings;
      sum += sun.radiance(angle) * 2.0 * kPi * std::sin(angle) * 0.5 * diameter / kRings;
    }
    // The law's root at the limb costs the radius' table of 1024 cells 1e-5.
    CHECK(sum == doctest::Approx(1.0).epsilon(2e-5));
    CHECK(sun.radiance(0.5 * diameter * 1.0001) == 0.0);
    CHECK(sun.radiance(kPi) == 0.0);
  }
}

TEST_CASE("the sun stands at azimuth 0 and its elevation") {
  for (const double elevation : {radians(-90), radians(-5), 0.0, radians(20), radians(90)}) {
    const Sun sun(sunAt(elevation, kDiameter));
    CHECK(glm::distance(sun.toCentre(), skyDirection(0.0, elevation)) < 1e-15);
    CHECK(std::abs(glm::length(toPoint(sun, 0.3, 0.4)) - 1.0) < 1e-14);
    CHECK_FALSE(sun.isPoint());
  }
}

TEST_CASE("a sun without extent is a point") {
  const Sun sun(sunAt(radians(20), 0.0));
  CHECK(sun.isPoint());
  CHECK(sun.radiance(0.0) == 0.0);
}
