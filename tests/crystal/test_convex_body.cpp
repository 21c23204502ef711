// SPDX-License-Identifier: Apache-2.0
#include "crystal/convex_body.h"

#include <cmath>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "crystal/crystal.h"
#include "crystal/shapes.h"
#include "random_stream.h"

using namespace parhelion;

namespace {

const double kApothem = 0.5 * std::sqrt(3.0);

std::set<int> numbersOf(const CrystalMesh& mesh) {
  std::set<int> numbers;
  for (const Face& face : mesh.faces()) numbers.insert(face.number);
  return numbers;
}

/// What the planes of a closed surface add up to: nothing. As a share of the surface.
double openness(const CrystalMesh& mesh) {
  Vec3 sum(0.0);
  for (const Face& face : mesh.faces()) sum += face.area * face.normal;
  return glm::length(sum) / Crystal{&mesh}.surface();
}

/// How far vertices lie from the planes of their faces, and outside those of others, over the radius.
double roughness(const CrystalMesh& mesh) {
  double worst = 0.0;
  for (const Face& face : mesh.faces()) {
    for (const int v : face.vertices)
      worst = std::max(worst, std::abs(glm::dot(face.normal, mesh.vertices()[v]) - face.offset));
    for (const Vec3& v : mesh.vertices()) worst = std::max(worst, glm::dot(face.normal, v) - face.offset);
  }
  return worst / mesh.radius();
}

std::vector<FacePlane> octahedron() {
  std::vector<FacePlane> planes;
  const double third = 1.0 / std::sqrt(3.0);
  for (int i = 0; i < 8; ++i)
    planes.push_back({i + 1, Vec3(i & 1 ? -third : third, i & 2 ? -third : third, i & 4 ? -third : third), third});
  return planes;
}

bool rejects(const std::vector<FacePlane>& planes, const std::string& why) {
  try {
    convexBody(planes);
    return false;
  } catch (const std::invalid_argument& error) {
    return std::string(error.what()).find(why) != std::string::npos;
  }
}

}  // namespace

TEST_CASE("planes of a regular prism make the prism") {
  std::vector<FacePlane> planes = endPlanes(0.4, -0.4);
  for (const FacePlane& plane : sidePlanes(kRegularSides)) planes.push_back(plane);
  const CrystalMesh cut = convexBody(planes), built = hexagonalPrism(0.4);
  REQUIRE(cut.faces().size() == built.faces().size());
  CHECK(cut.volume() == doctest::Approx(built.volume()).epsilon(1e-14));
  for (std::size_t i = 0; i < cut.faces().size(); ++i) {
    CHECK(cut.faces()[i].number == built.faces()[i].number);
    CHECK(cut.faces()[i].area == doctest::Approx(built.faces()[i].area).epsilon(1e-14));
    CHECK(glm::length(cut.faces()[i].normal - built.faces()[i].normal) < 1e-15);
  }
  CHECK(cut.isConvex());
  CHECK(cut.isPrismatic());
}

TEST_CASE("planes of pyramids make the pyramids, also where six planes meet in an apex") {
  for (const PyramidSettings& settings :
       {PyramidSettings{1.0, 0.5, 0.5}, PyramidSettings{0.3, 1.0, 0.2}, PyramidSettings{0.0, 1.0, 1.0},
        PyramidSettings{0.5, 0.0, 0.7}, PyramidSettings{0.2, 0.4, 0.4, radians(28.0), radians(60.0), radians(5.0)}}) {
    PyramidSettings nearly = settings;
    nearly.sides[0] = 1.0 + 1e-9;  // cut out of planes
    const CrystalMesh cut = meshOf(nearly), built = hexagonalPyramid(settings);
    CHECK(cut.volume() == doctest::Approx(built.volume()).epsilon(1e-8));
    CHECK(Crystal{&cut}.surface() == doctest::Approx(Crystal{&built}.surface()).epsilon(1e-8));
  }
}

TEST_CASE("faces that the others leave nothing of are no faces") {
  const CrystalMesh triangle = meshOf(PrismSettings{FixedValue{0.5}, {1.0, 2.0, 1.0, 2.0, 1.0, 2.0}});
  CHECK(numbersOf(triangle) == std::set<int>{1, 2, 3, 5, 7});
  // A triangle with an inscribed circle of radius r has the area 3 sqrt(3) r^2.
  CHECK(triangle.volume() == doctest::Approx(3.0 * std::sqrt(3.0) * kApothem * kApothem).epsilon(1e-14));
  // Face 6 beyond the axis.
  const CrystalMesh half = meshOf(PrismSettings{FixedValue{0.5}, {1.0, 1.0, 1.0, -0.25, 1.0, 1.0}});
  CHECK(openness(half) < 1e-15);
  CHECK(numbersOf(half) == std::set<int>{1, 2, 3, 4, 6, 8});
}

TEST_CASE("a regular octahedron comes of eight planes") {
  const CrystalMesh mesh = convexBody(octahedron());
  CHECK(mesh.vertices().size() == 6);
  CHECK(mesh.volume() == doctest::Approx(4.0 / 3.0).epsilon(1e-14));
  CHECK(roughness(mesh) < 1e-15);
}

TEST_CASE("planes that enclose nothing, or do not close, are refused") {
  std::vector<FacePlane> planes = octahedron();
  planes.push_back({9, Vec3(0.0, 0.0, 1.0), 5.0});  // far outside
  CHECK(convexBody(planes).faces().size() == 8);
  planes.back().distance = 1.0;  // touches a corner
  CHECK(convexBody(planes).faces().size() == 8);
  planes.back() = planes.front();  // the same plane twice
  planes.back().number = 9;
  CHECK(numbersOf(convexBody(planes)) == std::set<int>{1, 2, 3, 4, 5, 6, 7, 8});
  planes.back() = {9, Vec3(0.0, 0.0, 1.0), -2.0};
  CHECK(rejects(planes, "enclose nothing"));
  planes.pop_back();
  planes.pop_back();
  CHECK(rejects({}, "enclose nothing"));
  CHECK(rejects({planes.begin(), planes.begin() + 3}, "do not close"));
  CHECK(rejects(sidePlanes(kRegularSides), "do not close"));
  std::vector<FacePlane> many = octahedron();
  for (int i = 0; i < 40; ++i) {
    const double angle = 2.0 * 3.14159265358979 * i / 40.0;
    many.push_back({10 + i, Vec3(std::cos(angle), std::sin(angle), 0.0), 0.4});
  }
  CHECK(rejects(many, "at most 32 faces"));
}

TEST_CASE("a hundred thousand crystals of any sides, slopes and heights are closed, or refused") {
  int refused = 0, triangular = 0;
  double open = 0.0, rough = 0.0;
  for (int i = 0; i < 100'000; ++i) {
    RandomStream random(17, i, RandomPurpose::incidence);
    const auto between = [&](double from, double to) { return from + (to - from) * random.next(); };
    PyramidSettings crystal{random.next() < 0.2 ? 0.0 : std::pow(10.0, between(-3.0, 2.0))};
    for (double& side : crystal.sides) side = random.next() < 0.3 ? 1.0 : between(-0.5, 2.5);
    crystal.upper = random.next() < 0.2 ? std::round(random.next()) : random.next();
    crystal.lower = random.next() < 0.2 ? std::round(random.next()) : random.next();
    crystal.upperSlope = radians(random.next() < 0.5 ? between(0.1, 89.9) : 28.0);
    crystal.lowerSlope = radians(random.next() < 0.5 ? between(0.1, 89.9) : 28.0);
    try {
      const CrystalMesh mesh = meshOf(crystal);
      open = std::max(open, openness(mesh));
      rough = std::max(rough, roughness(mesh));
      CHECK(mesh.isConvex());
      if (mesh.faces().size() < 8) ++triangular;
    } catch (const std::invalid_argument&) {
      ++refused;
    }
  }
  CHECK(open < 1e-12);
  CHECK(rough < 1e-12);
  CHECK(triangular > 1000);
  MESSAGE("refused " << refused);
  CHECK(refused < 35'000);  // sides that enclose nothing, for the most part
}
