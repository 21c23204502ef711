// SPDX-License-Identifier: Apache-2.0
#include "crystal/orientation.h"

#include <cmath>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "orientations.h"
#include "random_stream.h"
#include "statistics.h"

using namespace parhelion;

namespace {

constexpr int kDraws = 200000;
const Vec3 kCAxis(0, 0, 1), kFace3(1, 0, 0), kEdge45(0, 1, 0);

/// Calls `test(crystalToWorld)` for many orientations.
template <class Test>
void forManyOrientations(const OrientationSettings& settings, int count, const Test& test) {
  const OrientationSampler sampler(settings);
  for (int i = 0; i < count; ++i) {
    RandomStream random(41, i, RandomPurpose::incidence);
    const double u1 = random.next(), u2 = random.next();
    test(matrixOf(sampler.quantile().at(u1, u2, random.next())));
  }
}

double tiltFromVertical(const Vec3& axis) { return std::atan2(std::hypot(axis.x, axis.y), std::abs(axis.z)); }

double zenithOf(const Vec3& axis) { return std::atan2(std::hypot(axis.x, axis.y), axis.z); }

/// Sky azimuth over a turn, from 0 to 1.
double turnOf(const Vec3& axis) { return skyPoint(axis).azimuth / (2.0 * kPi) + 0.5; }

/// The roll of an orientation over a turn, from 0 to 1.
double rollOf(const Mat3& crystalToWorld) {
  const Vec3 c = crystalToWorld[2];
  const Mat3 unrolled = crystalOrientation(zenithOf(c), skyPoint(c).azimuth, 0.0);
  const Vec3 face = glm::transpose(unrolled) * (crystalToWorld * kFace3);
  return std::atan2(face.y, face.x) / (2.0 * kPi) + 0.5;
}

double flat(double x) { return x; }

}  // namespace

TEST_CASE("every sampled orientation is a rotation") {
  for (const OrientationSettings& settings : std::initializer_list<OrientationSettings>{
           RandomOrientation{}, AxisOrientation{Normal{0.0, 0.1}}, AxisOrientation{Arcsine{0.0, 0.3}},
           LowitzOrientation{Normal{0.5 * kPi, 0.1}, UniformRange{0.0, 2.0 * kPi}}})
    forManyOrientations(settings, 1000, [](const Mat3& m) {
      const Mat3 rest = glm::transpose(m) * m - Mat3(1.0);
      for (int i = 0; i < 3; ++i) CHECK(glm::length(rest[i]) < 1e-14);
      CHECK(std::abs(glm::determinant(m) - 1.0) < 1e-14);
    });
}

TEST_CASE("random orientations are uniform: the c axis over the sphere and the roll about it, independently") {
  constexpr int kGrid = 8;
  std::vector<double> cosines, azimuths, rolls, cells(kGrid * kGrid * kGrid, 0.0);
  forManyOrientations(RandomOrientation{}, kDraws, [&](const Mat3& m) {
    const double cosine = 0.5 * (m[2].z + 1.0), azimuth = turnOf(m[2]), roll = rollOf(m);
    cosines.push_back(cosine);
    azimuths.push_back(azimuth);
    rolls.push_back(roll);
    const auto bin = [](double x) { return std::min(kGrid - 1, static_cast<int>(x * kGrid)); };
    ++cells[(bin(cosine) * kGrid + bin(azimuth)) * kGrid + bin(roll)];
  });
  for (const auto& values : {cosines, azimuths, rolls}) CHECK(chiSquareSigma(values, flat, 0.0, 1.0, 200) < kSigmas);
  CHECK(chiSquareSigma(cells, std::vector<double>(cells.size(), kDraws / double(cells.size()))) < kSigmas);
}

TEST_CASE("the angle of a random rotation from any other has the density (1 - cos) / pi") {
  // The Haar measure of SO(3), seen from an arbitrary orientation.
  const Mat3 other = crystalOrientation(1.1, 2.2, 3.3);
  std::vector<double> angles;
  forManyOrientations(RandomOrientation{}, kDraws, [&](const Mat3& m) {
    const Mat3 turn = glm::transpose(other) * m;
    angles.push_back(std::acos(std::clamp(0.5 * (turn[0].x + turn[1].y + turn[2].z - 1.0), -1.0, 1.0)));
  });
  CHECK(chiSquareSigma(
            angles, [](double a) { return (a - std::sin(a)) / kPi; }, 0.0, kPi, 200) < kSigmas);
}

TEST_CASE("the c axis of a random orientation reaches both poles") {
  const OrientationSampler sampler(RandomOrientation{});
  const auto cAxis = [&](double u1) { return matrixOf(sampler.quantile().at(u1, 0.3, 0.4))[2]; };
  // Near a pole 2 sqrt(u) is the angle from it.
  CHECK(tiltFromVertical(cAxis(1e-12)) == doctest::Approx(2e-6).epsilon(1e-6));
  CHECK(cAxis(0x1p-53).z == doctest::Approx(1.0));
  CHECK(cAxis(1.0 - 0x1p-53).z == doctest::Approx(-1.0));
}

TEST_CASE("level plates have a vertical c axis and any roll") {
  std::vector<double> turns;
  forManyOrientations(AxisOrientation{FixedValue{0.0}}, kDraws, [&](const Mat3& m) {
    CHECK(glm::distance(m * kCAxis, Vec3(0, 0, 1)) < 1e-15);
    turns.push_back(turnOf(m * kFace3));
  });
  CHECK(chiSquareSigma(turns, flat, 0.0, 1.0, 200) < kSigmas);
}

TEST_CASE("plates tilt by the given distribution, toward any side") {
  const double sigma = radians(2.0);
  std::vector<double> turns;
  SampleMean squares;
  forManyOrientations(AxisOrientation{Normal{0.0, sigma}}, kDraws, [&](const Mat3& m) {
    const double tilt = tiltFromVertical(m * kCAxis);
    squares.add(tilt * tilt);
    turns.push_back(turnOf(m * kCAxis));
  });
  // <t^2> = 2 sigma^2 (1 - sigma^2 / 3 ...): sigma is small enough to leave that out.
  CHECK(squares.sigmasFrom(2.0 * sigma * sigma) < kSigmas);
  CHECK(chiSquareSigma(turns, flat, 0.0, 1.0, 200) < kSigmas);
}

TEST_CASE("a fluttering plate's tilt is folded at the vertical") {
  const double amplitude = radians(5.0);
  std::vector<double> tilts;
  forManyOrientations(AxisOrientation{Arcsine{0.0, amplitude}}, kDraws,
                      [&](const Mat3& m) { tilts.push_back(tiltFromVertical(m * kCAxis) / amplitude); });
  for (double& t : tilts) t = std::min(t, 1.0);
  CHECK(chiSquareSigma(
            tilts, [](double t) { return 2.0 / kPi * std::asin(t); }, 0.0, 1.0, 100) < kSigmas);
}

TEST_CASE("columns have a horizontal c axis at any azimuth and any roll") {
  std::vector<double> turns, rolls;
  forManyOrientations(AxisOrientation{FixedValue{0.5 * kPi}}, kDraws, [&](const Mat3& m) {
    CHECK(std::abs((m * kCAxis).z) < 1e-15);
    turns.push_back(turnOf(m * kCAxis));
    rolls.push_back(rollOf(m));
  });
  CHECK(chiSquareSigma(turns, flat, 0.0, 1.0, 200) < kSigmas);
  CHECK(chiSquareSigma(rolls, flat, 0.0, 1.0, 200) < kSigmas);
}

TEST_CASE("Parry columns keep faces 3 and 6 level and an edge sideways") {
  const AxisOrientation parry{FixedValue{0.5 * kPi}, UniformRange{0.0, 2.0 * kPi}, FixedValue{0.0}};
  forManyOrientations(parry, 1000, [](const Mat3& m) {
    CHECK(std::abs((m * kCAxis).z) < 1e-15);
    CHECK(std::abs(std::abs((m * kFace3).z) - 1.0) < 1e-15);
    CHECK(std::abs((m * kEdge45).z) < 1e-15);
  });
}

TEST_CASE("Lowitz plates spin about a horizontal axis through two opposite prism edges") {
  std::vector<double> turns, spins;
  forManyOrientations(LowitzOrientation{}, kDraws, [&](const Mat3& m) {
    const Vec3 axis = m * kEdge45, c = m * kCAxis;
    CHECK(std::abs(axis.z) < 1e-15);
    turns.push_back(turnOf(axis));
    spins.push_back(std::atan2((m * kFace3).z, c.z) / (2.0 * kPi) + 0.5);
  });
  CHECK(chiSquareSigma(turns, flat, 0.0, 1.0, 200) < kSigmas);
  CHECK(chiSquareSigma(spins, flat, 0.0, 1.0, 200) < kSigmas);
}

TEST_CASE("the spin of a Lowitz plate is counted from where its c axis is highest") {
  const double axisZenith = radians(80.0);
  for (const double spin : {0.0, 0.4, -1.3}) {
    const LowitzOrientation lowitz{FixedValue{axisZenith}, FixedValue{spin}};
    forManyOrientations(lowitz, 200, [&](const Mat3& m) {
      CHECK(zenithOf(m * kEdge45) == doctest::Approx(axisZenith).epsilon(1e-12));
      // c turns in the plane across the axis, whose highest direction stands at 90 degrees minus the axis' elevation.
      CHECK((m * kCAxis).z == doctest::Approx(std::sin(axisZenith) * std::cos(spin)).epsilon(1e-12));
    });
  }
}

TEST_CASE("a given azimuth and roll are kept") {
  const AxisOrientation axis{FixedValue{1.0}, FixedValue{2.0}, FixedValue{0.5}};
  const Mat3 expected = crystalOrientation(1.0, 2.0, 0.5);
  forManyOrientations(axis, 10, [&](const Mat3& m) {
    for (int k = 0; k < 3; ++k) CHECK(glm::length(m[k] - expected[k]) < 1e-15);
  });
}

TEST_CASE("zenith angles beyond the poles fold back") {
  const AxisOrientation beyond{FixedValue{-0.2}, FixedValue{0.0}, FixedValue{0.0}};
  forManyOrientations(beyond, 1, [](const Mat3& m) {
    CHECK(zenithOf(m * kCAxis) == doctest::Approx(0.2));
    CHECK(std::abs(skyPoint(m * kCAxis).azimuth) == doctest::Approx(kPi));
  });
}
