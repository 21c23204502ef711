// SPDX-License-Identifier: Apache-2.0
#include "math/rotation.h"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "orientations.h"
#include "random_stream.h"

using namespace parhelion;

namespace {

double worstEntry(const Mat3& m) {
  double worst = 0.0;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) worst = std::fmax(worst, std::abs(m[column][row]));
  return worst;
}

/// How far `m` is from a rotation: its columns from orthonormal, its determinant from +1.
double rotationError(const Mat3& m) {
  return std::fmax(worstEntry(glm::transpose(m) * m - Mat3(1.0)), std::abs(glm::determinant(m) - 1.0));
}

/// Calls `test(u)` for many triples of numbers in (0, 1).
template <class Test>
void forManyTriples(const Test& test) {
  for (int i = 0; i < 2000; ++i) {
    RandomStream random(9, i, RandomPurpose::path);
    const double a = random.next(), b = random.next();
    test(Vec3(a, b, random.next()));
  }
}

constexpr double kRounding = 1e-14;

}  // namespace

TEST_CASE("the sun's azimuth is +x, the right hand of who faces it is azimuth +90 and -y, the zenith is +z") {
  CHECK(glm::distance(skyDirection(0.0, 0.0), Vec3(1, 0, 0)) < kRounding);
  CHECK(glm::distance(skyDirection(radians(90), 0.0), Vec3(0, -1, 0)) < kRounding);
  CHECK(glm::distance(skyDirection(radians(-90), 0.0), Vec3(0, 1, 0)) < kRounding);
  CHECK(glm::distance(skyDirection(1.0, radians(90)), Vec3(0, 0, 1)) < kRounding);
  CHECK(skyDirection(0.0, radians(30)).z == doctest::Approx(0.5));
}

TEST_CASE("azimuth and elevation lead to a direction and back") {
  forManyTriples([](const Vec3& u) {
    const double azimuth = kPi * (2.0 * u.x - 1.0), elevation = 0.49 * kPi * (2.0 * u.y - 1.0);
    const Vec3 direction = skyDirection(azimuth, elevation);
    CHECK(std::abs(glm::length(direction) - 1.0) < kRounding);
    const SkyPoint point = skyPoint(direction);
    CHECK(std::abs(point.azimuth - azimuth) < 2e-14);
    CHECK(std::abs(point.elevation - elevation) < kRounding);
  });
}

TEST_CASE("the azimuth is 0 at the poles and +180 degrees, never -180, opposite the sun") {
  for (const double z : {1.0, -1.0}) {
    const SkyPoint pole = skyPoint({0, 0, z});
    CHECK(pole.azimuth == 0.0);
    CHECK(pole.elevation == doctest::Approx(z * kPi / 2));
    CHECK(skyPoint({-0.0, 0.0, z}).azimuth == 0.0);
  }
  CHECK(skyPoint({-1, 0.0, 0}).azimuth == kPi);
  CHECK(skyPoint({-1, -0.0, 0}).azimuth == kPi);
  // Beside a pole the azimuth is still defined.
  CHECK(skyPoint({0, -1e-150, 1}).azimuth == doctest::Approx(kPi / 2));
}

TEST_CASE("the angle between vectors is exact near 0 and 180 degrees, where acos fails") {
  for (const double angle : {1e-3, 1e-6, 1e-9, 1e-12, 1e-100}) {
    const Vec3 a(0, 0, 1), b(std::sin(angle), 0, std::cos(angle));
    CHECK(std::abs(angleBetween(a, b) / angle - 1.0) < kRounding);
    CHECK(std::abs(angleBetween(a, -b) - (kPi - angle)) < 1e-15);
  }
  CHECK(angleBetween({1, 2, 3}, {1, 2, 3}) == 0.0);
  CHECK(angleBetween({1, 2, 3}, {-1, -2, -3}) == kPi);
}

TEST_CASE("the angle between vectors does not depend on their lengths") {
  CHECK(angleBetween({3, 0, 0}, {0, 1e-5, 0}) == doctest::Approx(kPi / 2));
  CHECK(angleBetween({2, 0, 0}, {5, 5, 0}) == doctest::Approx(kPi / 4));
}

TEST_CASE("rotations about the axes are right-handed") {
  const double right = 0.5 * kPi;
  CHECK(glm::distance(rotationX(right) * Vec3(0, 1, 0), Vec3(0, 0, 1)) < kRounding);
  CHECK(glm::distance(rotationY(right) * Vec3(0, 0, 1), Vec3(1, 0, 0)) < kRounding);
  CHECK(glm::distance(rotationZ(right) * Vec3(1, 0, 0), Vec3(0, 1, 0)) < kRounding);
  for (const double angle : {-4.0, 0.3, 2.0})
    for (const Mat3& m : {rotationX(angle), rotationY(angle), rotationZ(angle)}) CHECK(rotationError(m) < kRounding);
}

TEST_CASE("a crystal's c axis points where its zenith angle and azimuth say, at any roll") {
  forManyTriples([](const Vec3& u) {
    const double zenith = kPi * u.x, azimuth = 2.0 * kPi * u.y, roll = 2.0 * kPi * u.z;
    const Mat3 crystalToWorld = crystalOrientation(zenith, azimuth, roll);
    CHECK(rotationError(crystalToWorld) < kRounding);
    CHECK(glm::distance(crystalToWorld * Vec3(0, 0, 1), skyDirection(azimuth, 0.5 * kPi - zenith)) < kRounding);
  });
}

TEST_CASE("at roll 0 the normals of faces 3 and 6 lie in the vertical plane through the c axis") {
  forManyTriples([](const Vec3& u) {
    const double zenith = kPi * u.x, azimuth = 2.0 * kPi * u.y;
    // The horizontal direction across that plane.
    const Vec3 across(std::sin(azimuth), std::cos(azimuth), 0.0);
    for (const double face : {1.0, -1.0})
      CHECK(std::abs(glm::dot(crystalOrientation(zenith, azimuth, 0.0) * Vec3(face, 0, 0), across)) < kRounding);
    // A roll turns them out of it by that angle, counter-clockwise about c.
    const Vec3 rolled = crystalOrientation(zenith, azimuth, 0.3) * Vec3(1, 0, 0);
    CHECK(glm::dot(rolled, across) == doctest::Approx(std::sin(0.3)));
  });
}

TEST_CASE("a frame around an axis is a rotation that takes +z to the axis") {
  forManyTriples([](const Vec3& u) {
    const Vec3 axis = skyDirection(2.0 * kPi * u.x, kPi * (u.y - 0.5));
    CHECK(frameAround(axis)[2] == axis);
    CHECK(rotationError(frameAround(axis)) < kRounding);
  });
  for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)})
    CHECK(rotationError(frameAround(axis)) < kRounding);
}
