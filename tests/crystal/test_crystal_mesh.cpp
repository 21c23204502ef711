// SPDX-License-Identifier: Apache-2.0
#include "crystal/crystal_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "crystal/crystal.h"
#include "crystal/shapes.h"

using namespace parhelion;

namespace {

/// What a mesh is made of, so that a test can spoil it.
struct Parts {
  std::vector<Vec3> vertices;
  std::vector<FaceOutline> outlines;

  CrystalMesh build() const { return {vertices, outlines}; }

  FaceOutline& face(int number) {
    return *std::find_if(outlines.begin(), outlines.end(), [=](const FaceOutline& f) { return f.number == number; });
  }
};

Parts prismParts() {
  const CrystalMesh mesh = hexagonalPrism(1.0);
  Parts parts{mesh.vertices(), {}};
  for (const Face& face : mesh.faces()) parts.outlines.push_back({face.number, face.vertices});
  return parts;
}

/// A right prism of height 1 over a polygon given counter-clockwise: faces 1 and 2, then 3, 4, ... around.
Parts prismOver(const std::vector<Vec2>& polygon) {
  Parts parts;
  const int n = static_cast<int>(polygon.size());
  for (const double z : {0.0, 1.0})
    for (const Vec2& p : polygon) parts.vertices.emplace_back(p, z);
  FaceOutline top{1, {}}, bottom{2, {}};
  for (int i = 0; i < n; ++i) {
    top.vertices.push_back(n + i);
    bottom.vertices.push_back(n - 1 - i);
    parts.outlines.push_back({3 + i, {i, (i + 1) % n, n + (i + 1) % n, n + i}});
  }
  parts.outlines.push_back(top);
  parts.outlines.push_back(bottom);
  return parts;
}

std::vector<Vec2> regularPolygon(int corners) {
  std::vector<Vec2> polygon;
  for (int i = 0; i < corners; ++i)
    polygon.emplace_back(std::cos(2.0 * kPi * i / corners), std::sin(2.0 * kPi * i / corners));
  return polygon;
}

/// The message with which the parts are rejected, or nothing.
std::string complaintAbout(const Parts& parts) {
  try {
    parts.build();
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

}  // namespace

TEST_CASE("a mesh rebuilt from its own parts is the same") {
  const CrystalMesh a = hexagonalPrism(1.0), b = prismParts().build();
  CHECK(a.volume() == b.volume());
  CHECK(Crystal{&a}.surface() == Crystal{&b}.surface());
}

TEST_CASE("the surface and volume of a cuboid away from the origin") {
  Parts parts = prismOver({{0, 0}, {2, 0}, {2, 3}, {0, 3}});
  for (Vec3& v : parts.vertices) v += Vec3(10, -20, 30);
  const CrystalMesh mesh = parts.build();
  CHECK(mesh.volume() == doctest::Approx(6.0).epsilon(1e-13));
  CHECK(Crystal{&mesh}.surface() == doctest::Approx(22.0).epsilon(1e-13));
  CHECK(mesh.isConvex());
  CHECK(mesh.isPrismatic());
}

TEST_CASE("a mesh with a face missing is not closed") {
  for (int i = 0; i < 8; ++i) {
    Parts parts = prismParts();
    parts.outlines.erase(parts.outlines.begin() + i);
    CHECK(contains(complaintAbout(parts), "not closed"));
  }
}

TEST_CASE("a mesh with a face turned over or given twice is rejected") {
  for (int number = 1; number <= 8; ++number) {
    Parts flipped = prismParts(), doubled = prismParts();
    std::reverse(flipped.face(number).vertices.begin(), flipped.face(number).vertices.end());
    CHECK(contains(complaintAbout(flipped), "not closed"));
    doubled.outlines.push_back(doubled.face(number));
    CHECK(contains(complaintAbout(doubled), "not closed"));
  }
}

TEST_CASE("a mesh turned inside out is rejected") {
  Parts parts = prismParts();
  for (FaceOutline& f : parts.outlines) std::reverse(f.vertices.begin(), f.vertices.end());
  CHECK(contains(complaintAbout(parts), "inside out"));
}

TEST_CASE("a mesh without faces is rejected") {
  CHECK_THROWS_AS(CrystalMesh({}, std::vector<FaceOutline>{}), std::invalid_argument);
  CHECK_THROWS_AS(CrystalMesh(prismParts().vertices, std::vector<FaceOutline>{}), std::invalid_argument);
}

TEST_CASE("a face that is not planar is rejected by its number") {
  Parts parts = prismParts();
  // Moved along c the corner stays in the planes of the two prism faces that share it.
  parts.vertices[parts.face(1).vertices[2]].z += 1e-9;
  CHECK(contains(complaintAbout(parts), "is not planar"));
  CHECK(contains(complaintAbout(parts), "crystal face 1 "));
}

TEST_CASE("a concave face is rejected by its number") {
  const Parts parts = prismOver({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  CHECK(contains(complaintAbout(parts), "crystal face 1 is not convex"));
}

TEST_CASE("a face without area, of two corners, or of corners that do not exist is rejected") {
  Parts parts = prismParts();
  parts.face(5).vertices.resize(2);
  CHECK(contains(complaintAbout(parts), "crystal face 5 has fewer than three vertices"));
  for (const int bad : {-1, 12, 1000}) {
    parts = prismParts();
    parts.face(4).vertices[2] = bad;
    CHECK(contains(complaintAbout(parts), "crystal face 4 names a vertex that does not exist"));
  }
  parts = prismParts();
  for (Vec3& v : parts.vertices) v.z = 0.0;
  CHECK(contains(complaintAbout(parts), "has no area"));
}

TEST_CASE("a vertex that is not finite is rejected") {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity}) {
    Parts parts = prismParts();
    parts.vertices[3].y = bad;
    CHECK(contains(complaintAbout(parts), "not finite"));
  }
}

TEST_CASE("a crystal has at most 32 faces") {
  CHECK(prismOver(regularPolygon(30)).build().faces().size() == 32);
  CHECK(contains(complaintAbout(prismOver(regularPolygon(31))), "at most 32 faces"));
}

TEST_CASE("a prism with a hollow end is closed but not convex") {
  Parts parts = prismParts();
  const std::vector<int> rim = parts.face(1).vertices;
  parts.outlines.erase(
      std::find_if(parts.outlines.begin(), parts.outlines.end(), [](const FaceOutline& f) { return f.number == 1; }));
  // A pyramid sunk into the upper basal face.
  const int apex = static_cast<int>(parts.vertices.size());
  parts.vertices.emplace_back(0.0, 0.0, 0.25);
  for (int i = 0; i < 6; ++i) parts.outlines.push_back({13 + i, {rim[i], rim[(i + 1) % 6], apex}});
  const CrystalMesh mesh = parts.build();
  CHECK_FALSE(mesh.isConvex());
  CHECK_FALSE(mesh.isPrismatic());
  const double base = 1.5 * std::sqrt(3.0);
  CHECK(mesh.volume() == doctest::Approx(base * (2.0 - 0.75 / 3.0)).epsilon(1e-13));
}

TEST_CASE("a face tilted by a millionth of a radian stays tilted, at any inclination to c") {
  // A prism with one end cut obliquely, and one whose sides lean.
  Parts oblique = prismParts(), leaning = prismParts();
  for (Vec3& v : oblique.vertices)
    if (v.z > 0.0) v.z += 1e-6 * v.x;
  for (Vec3& v : leaning.vertices) v.x += 1e-6 * v.z;
  CHECK_FALSE(oblique.build().isPrismatic());
  CHECK_FALSE(leaning.build().isPrismatic());
}

TEST_CASE("rounding does not tilt faces along or across the c axis") {
  Parts parts = prismParts();
  for (Vec3& v : parts.vertices) v.z *= 1.0 + 1e-15 * v.x;
  const CrystalMesh mesh = parts.build();
  CHECK(mesh.isPrismatic());
  for (const Face& face : mesh.faces()) CHECK(std::abs(glm::length(face.normal) - 1.0) < 1e-15);
}
