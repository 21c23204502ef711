// SPDX-License-Identifier: Apache-2.0
// Spreads that reach beyond a pole: a rotation by a signed angle brings the axis down on the other side.
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "crystal/orientation.h"
#include "orientations.h"
#include "random_stream.h"
#include "statistics.h"

using namespace parhelion;

namespace {

constexpr int kDraws = 200'000, kBins = 180;
constexpr double kTurn = 2.0 * kPi;
constexpr double kSide = radians(30.0);  // azimuth of the axis where its zenith angle is from 0 to pi

struct Example {
  std::string name;
  AngleDistribution zenith;
  std::function<double(double)> cumulative;  // of the signed angle, over all turns
};

double deg(double d) { return radians(d); }

Example uniform(double from, double to) {
  return {"uniform", UniformRange{from, to}, [=](double x) { return std::clamp((x - from) / (to - from), 0.0, 1.0); }};
}
Example normal(double mean, double sigma) {
  const auto density = [=](double x) {
    return std::exp(-0.5 * (x - mean) * (x - mean) / (sigma * sigma)) * std::abs(std::sin(x));
  };
  return {"normal", Normal{mean, sigma}, cumulativeOf(density, mean - 8.0 * sigma, mean + 8.0 * sigma)};
}
Example polarNormal(double mean, double sigma) {
  return {"polar-normal", PolarNormal{mean, sigma},
          [=](double x) { return 0.5 * std::erfc((mean - x) / (sigma * std::sqrt(2.0))); }};
}
Example arcsine(double mean, double amplitude) {
  return {"arcsine", Arcsine{mean, amplitude},
          [=](double x) { return 0.5 + std::asin(std::clamp((x - mean) / amplitude, -1.0, 1.0)) / kPi; }};
}
Example laplace(double mean, double scale) {
  return {"laplace", Laplace{mean, scale}, [=](double x) {
            const double tail = 0.5 * std::exp(-std::abs(x - mean) / scale);
            return x < mean ? tail : 1.0 - tail;
          }};
}

/// Each distribution through the zenith, through the nadir, and through both, as wide tilts of columns are.
std::vector<Example> examples() {
  std::vector<Example> all;
  for (const double pole : {0.0, kPi})
    for (const double aside : {0.0, deg(5)}) {
      const double mean = pole == 0.0 ? aside : pole - aside;
      all.insert(all.end(), {uniform(mean - deg(10), mean + deg(10)), normal(mean, deg(5)), polarNormal(mean, deg(5)),
                             arcsine(mean, deg(12)), laplace(mean, deg(10))});
    }
  const double level = deg(90);
  all.insert(all.end(), {uniform(level - deg(120), level + deg(120)), normal(level, deg(60)),
                         polarNormal(level, deg(60)), arcsine(level, deg(150)), laplace(level, deg(40))});
  return all;
}

std::vector<Vec3> axesOf(const AngleDistribution& zenith, const AngleDistribution& azimuth) {
  const OrientationSampler sampler(AxisOrientation{zenith, azimuth, FixedValue{0.0}});
  std::vector<Vec3> axes;
  for (int i = 0; i < kDraws; ++i) {
    RandomStream random(47, i, RandomPurpose::incidence);
    const double u1 = random.next(), u2 = random.next();
    axes.push_back(matrixOf(sampler.quantile().at(u1, u2, 0.5))[2]);
  }
  return axes;
}

double zenithOf(const Vec3& axis) { return std::atan2(std::hypot(axis.x, axis.y), axis.z); }

/// Turns enough for all but a hundred thousandth of any of the examples.
constexpr int kTurns = 3;

/// How far signed angles from the zenith are from an example's density, wrapped around the circle.
double sigmasOfSignedAngles(const std::vector<double>& angles, const Example& example) {
  const auto wrapped = [&](double x) {
    double sum = 0.0;
    for (int k = -kTurns; k <= kTurns; ++k)
      sum += example.cumulative(x + k * kTurn) - example.cumulative(-kPi + k * kTurn);
    return sum;
  };
  return chiSquareSigma(angles, wrapped, -kPi, kPi, 2 * kBins);
}

}  // namespace

TEST_CASE("an axis with an azimuth of its own is turned through the poles by a signed angle") {
  const Vec3 side = skyDirection(kSide, 0.0);
  for (const Example& example : examples()) {
    CAPTURE(example.name);
    CAPTURE(degrees(centreOf(example.zenith)));
    std::vector<double> angles;
    for (const Vec3& axis : axesOf(example.zenith, FixedValue{kSide})) {
      // It stays in one vertical plane.
      REQUIRE(std::abs(glm::dot(axis, glm::cross(side, Vec3(0, 0, 1)))) < 1e-14);
      angles.push_back(std::copysign(zenithOf(axis), glm::dot(axis, side)));
    }
    CHECK(sigmasOfSignedAngles(angles, example) < kSigmas);
  }
}

TEST_CASE("the zenith angle of an axis at any azimuth has the density of both sides of a pole together") {
  for (const Example& example : examples()) {
    CAPTURE(example.name);
    CAPTURE(degrees(centreOf(example.zenith)));
    std::vector<double> angles, turns;
    for (const Vec3& axis : axesOf(example.zenith, UniformRange{0.0, kTurn})) {
      angles.push_back(zenithOf(axis));
      turns.push_back(skyPoint(axis).azimuth);
    }
    const auto folded = [&](double z) {
      double sum = 0.0;
      for (int k = -kTurns; k <= kTurns; ++k)
        sum += example.cumulative(k * kTurn + z) - example.cumulative(k * kTurn - z);
      return sum;
    };
    CHECK(chiSquareSigma(angles, folded, 0.0, kPi, 2 * kBins) < kSigmas);
    CHECK(chiSquareSigma(
              turns, [](double a) { return a / kTurn + 0.5; }, -kPi, kPi, kBins) < kSigmas);
  }
}

TEST_CASE("beyond a pole azimuth and roll are half a turn further") {
  const auto matrix = [](double zenith, double azimuth, double roll) {
    const OrientationSampler sampler(AxisOrientation{FixedValue{zenith}, FixedValue{azimuth}, FixedValue{roll}});
    return matrixOf(sampler.quantile().at(0.5, 0.5, 0.5));
  };
  for (const double zenith : {0.2, 1.5, 3.0})
    for (const double azimuth : {0.0, 0.7}) {
      const Mat3 beyond = matrix(-zenith, azimuth, 0.4), under = matrix(kTurn - zenith, azimuth, 0.4);
      const Mat3 expected = matrix(zenith, azimuth + kPi, 0.4 + kPi);
      for (int k = 0; k < 3; ++k) {
        CHECK(glm::distance(beyond[k], expected[k]) < 1e-14);
        CHECK(glm::distance(under[k], expected[k]) < 1e-14);
      }
    }
}

TEST_CASE("the axis of a Lowitz plate is turned through the poles, too") {
  const double spin = 0.4;
  for (const Example& example : examples()) {
    CAPTURE(example.name);
    const OrientationSampler sampler(LowitzOrientation{example.zenith, FixedValue{spin}});
    std::vector<double> angles;
    for (int i = 0; i < kDraws; ++i) {
      RandomStream random(48, i, RandomPurpose::incidence);
      const Mat3 m = matrixOf(sampler.quantile().at(random.next(), 0.3, 0.5));
      // At zenith angle z of +y the c axis stands at height sin z cos(spin): below the horizon for a negative z.
      angles.push_back(std::copysign(zenithOf(m[1]), m[2].z));
    }
    CHECK(sigmasOfSignedAngles(angles, example) < kSigmas);
  }
}
