// SPDX-License-Identifier: Apache-2.0
#include "crystal/shapes.h"

#include <cmath>
#include <set>
#include <stdexcept>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "crystal/crystal.h"
#include "math/rotation.h"

using namespace parhelion;

namespace {

const Face& faceOf(const CrystalMesh& mesh, int number) {
  for (const Face& face : mesh.faces())
    if (face.number == number) return face;
  throw std::out_of_range("no face " + std::to_string(number));
}

std::set<int> numbersOf(const CrystalMesh& mesh) {
  std::set<int> numbers;
  for (const Face& face : mesh.faces()) numbers.insert(face.number);
  CHECK(numbers.size() == mesh.faces().size());
  return numbers;
}

/// The angle of the wedge of ice between two faces, degrees.
double wedge(const CrystalMesh& mesh, int a, int b) {
  return 180.0 - degrees(angleBetween(faceOf(mesh, a).normal, faceOf(mesh, b).normal));
}

/// Outward normal of prism face 3-8.
Vec3 prismNormal(int number) {
  const double angle = radians(60.0 * (number - 3));
  return {std::cos(angle), std::sin(angle), 0.0};
}

PyramidSettings pyramid(double aspect, double upper, double lower) {
  PyramidSettings settings;
  settings.aspect = aspect;
  settings.upper = upper;
  settings.lower = lower;
  return settings;
}

const double kRoot3 = std::sqrt(3.0);
const double kApexHeight = 0.5 * kRoot3 / std::tan(radians(28.0));

}  // namespace

TEST_CASE("a hexagonal prism has surface 6aL + 3 sqrt(3) a^2 and volume 1.5 sqrt(3) a^2 L at any aspect ratio") {
  for (double aspect = 1e-4; aspect < 2e4; aspect *= 10.0) {
    INFO("aspect " << aspect);
    const CrystalMesh mesh = hexagonalPrism(aspect);
    const double length = 2.0 * aspect;
    CHECK(Crystal{&mesh}.surface() == doctest::Approx(6.0 * length + 3.0 * kRoot3).epsilon(1e-13));
    CHECK(mesh.volume() == doctest::Approx(1.5 * kRoot3 * length).epsilon(1e-12));
    CHECK(mesh.radius() == doctest::Approx(std::sqrt(1.0 + aspect * aspect)).epsilon(1e-14));
    CHECK(mesh.isConvex());
    CHECK(mesh.isPrismatic());
  }
}

TEST_CASE("prism faces are numbered as halo science numbers them") {
  const CrystalMesh mesh = hexagonalPrism(0.7);
  CHECK(numbersOf(mesh) == std::set<int>{1, 2, 3, 4, 5, 6, 7, 8});
  CHECK(faceOf(mesh, 1).normal == Vec3(0, 0, 1));
  CHECK(faceOf(mesh, 2).normal == Vec3(0, 0, -1));
  CHECK(faceOf(mesh, 1).offset == doctest::Approx(0.7).epsilon(1e-15));
  CHECK(glm::distance(faceOf(mesh, 3).normal, Vec3(1, 0, 0)) < 1e-15);
  for (int number = 3; number <= 8; ++number) {
    const Face& face = faceOf(mesh, number);
    CHECK(glm::distance(face.normal, prismNormal(number)) < 1e-15);
    CHECK(face.normal.z == 0.0);
    CHECK(face.offset == doctest::Approx(0.5 * kRoot3).epsilon(1e-15));
    CHECK(face.area == doctest::Approx(1.4).epsilon(1e-14));
  }
  CHECK(wedge(mesh, 3, 5) == doctest::Approx(60.0));
  CHECK(wedge(mesh, 1, 3) == doctest::Approx(90.0));
}

TEST_CASE("the crystal's +y passes through the edge between faces 4 and 5") {
  const CrystalMesh mesh = hexagonalPrism(1.0);
  int corners = 0;
  for (const int v : faceOf(mesh, 4).vertices)
    for (const int w : faceOf(mesh, 5).vertices)
      if (v == w) {
        ++corners;
        CHECK(mesh.vertices()[v].x == 0.0);
        CHECK(mesh.vertices()[v].y == 1.0);
      }
  CHECK(corners == 2);
}

TEST_CASE("faces turn counter-clockwise seen from outside") {
  for (const CrystalMesh& mesh : {hexagonalPrism(1.0), hexagonalPyramid(pyramid(0.3, 0.4, 1.0))})
    for (const Face& face : mesh.faces()) {
      const Vec3 a = mesh.vertices()[face.vertices[0]], b = mesh.vertices()[face.vertices[1]];
      const Vec3 c = mesh.vertices()[face.vertices[2]];
      CHECK(glm::dot(glm::cross(b - a, c - b), face.normal) > 0.0);
      // The origin is inside these crystals.
      CHECK(face.offset > 0.0);
    }
}

TEST_CASE("pyramid faces make their slope with the c axis and stand above and below the prism faces") {
  for (const double slope : {28.0, 15.0, 60.0}) {
    PyramidSettings settings = pyramid(0.5, 0.6, 0.3);
    settings.slope = radians(slope);
    const CrystalMesh mesh = hexagonalPyramid(settings);
    for (int k = 3; k <= 8; ++k) {
      const Vec3 upper = faceOf(mesh, 10 + k).normal, lower = faceOf(mesh, 20 + k).normal;
      CHECK(std::asin(upper.z) == doctest::Approx(radians(slope)).epsilon(1e-13));
      CHECK(std::asin(lower.z) == doctest::Approx(-radians(slope)).epsilon(1e-13));
      CHECK(glm::distance(glm::normalize(Vec3(upper.x, upper.y, 0)), prismNormal(k)) < 1e-14);
      CHECK(glm::distance(glm::normalize(Vec3(lower.x, lower.y, 0)), prismNormal(k)) < 1e-14);
    }
    CHECK(mesh.isConvex());
    CHECK_FALSE(mesh.isPrismatic());
  }
}

TEST_CASE("the wedges of a {10-11} pyramid are those of the odd-radius halos") {
  const CrystalMesh mesh = hexagonalPyramid(pyramid(1.0, 0.5, 0.5));
  const auto near = [](double degrees) { return doctest::Approx(degrees).epsilon(1e-5); };
  CHECK(wedge(mesh, 3, 16) == near(28.0));
  CHECK(wedge(mesh, 3, 26) == near(28.0));
  CHECK(wedge(mesh, 13, 25) == near(52.396));
  CHECK(wedge(mesh, 13, 16) == near(56.0));
  CHECK(wedge(mesh, 3, 5) == near(60.0));
  CHECK(wedge(mesh, 1, 23) == near(62.0));
  CHECK(wedge(mesh, 3, 15) == near(63.802));
  CHECK(wedge(mesh, 13, 15) == near(80.247));
  CHECK(wedge(mesh, 1, 3) == near(90.0));
}

TEST_CASE("a pyramid has the faces that its settings leave it") {
  const auto faces = [](double aspect, double upper, double lower) {
    return numbersOf(hexagonalPyramid(pyramid(aspect, upper, lower)));
  };
  using Set = std::set<int>;
  const Set prism = {3, 4, 5, 6, 7, 8}, above = {13, 14, 15, 16, 17, 18}, below = {23, 24, 25, 26, 27, 28};
  const auto join = [](std::initializer_list<Set> sets) {
    Set all;
    for (const Set& s : sets) all.insert(s.begin(), s.end());
    return all;
  };
  CHECK(faces(1.0, 0.5, 0.5) == join({{1, 2}, prism, above, below}));
  CHECK(faces(1.0, 1.0, 1.0) == join({prism, above, below}));
  CHECK(faces(0.0, 1.0, 1.0) == join({above, below}));
  CHECK(faces(0.0, 0.2, 0.9) == join({{1, 2}, above, below}));
  CHECK(faces(0.0, 0.5, 0.0) == join({{1, 2}, above}));
  CHECK(faces(0.0, 0.0, 1.0) == join({{1}, below}));
  CHECK(faces(2.0, 1.0, 0.0) == join({{2}, prism, above}));
  CHECK(faces(2.0, 0.0, 0.0) == join({{1, 2}, prism}));
}

TEST_CASE("a pyramid's volume is that of its prism and its frusta") {
  const double base = 1.5 * kRoot3;
  for (const double aspect : {0.0, 0.01, 1.0, 50.0})
    for (const double upper : {0.0, 0.3, 1.0})
      for (const double lower : {0.2, 1.0}) {
        const CrystalMesh mesh = hexagonalPyramid(pyramid(aspect, upper, lower));
        const auto frustum = [&](double h) { return base * kApexHeight * (1.0 - std::pow(1.0 - h, 3.0)) / 3.0; };
        CHECK(mesh.volume() == doctest::Approx(base * 2.0 * aspect + frustum(upper) + frustum(lower)).epsilon(1e-12));
        CHECK(mesh.isConvex());
      }
}

TEST_CASE("a full apex stands at the height of its pyramid above the prism") {
  const CrystalMesh mesh = hexagonalPyramid(pyramid(0.25, 1.0, 0.5));
  double top = 0.0, bottom = 0.0;
  for (const Vec3& v : mesh.vertices()) {
    top = std::fmax(top, v.z);
    bottom = std::fmin(bottom, v.z);
  }
  CHECK(top == doctest::Approx(0.25 + kApexHeight).epsilon(1e-14));
  CHECK(bottom == doctest::Approx(-0.25 - 0.5 * kApexHeight).epsilon(1e-14));
}

TEST_CASE("shapes that enclose nothing are rejected") {
  CHECK_THROWS_AS(hexagonalPyramid(pyramid(0.0, 0.0, 0.0)), std::invalid_argument);
  CHECK_THROWS_AS(hexagonalPrism(0.0), std::invalid_argument);
  CHECK_THROWS_AS(hexagonalPrism(-1.0), std::invalid_argument);
  CHECK_THROWS_AS(hexagonalPrism(NAN), std::invalid_argument);
  CHECK_THROWS_AS(hexagonalPyramid(pyramid(1.0, 1.5, 0.5)), std::invalid_argument);
  CHECK_THROWS_AS(hexagonalPyramid(pyramid(-1.0, 0.5, 0.5)), std::invalid_argument);
  CHECK_THROWS_AS(hexagonalPyramid(pyramid(1e-9, 0.0, 0.0)), std::invalid_argument);
  CHECK_THROWS_AS(hexagonalPyramid({1.0, 0.5, 0.5, radians(1e-6)}), std::invalid_argument);
  CHECK_THROWS_AS(hexagonalPyramid({1.0, 0.5, 0.5, NAN}), std::invalid_argument);
}
