// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "crystal/crystal.h"
#include "crystal/isometry.h"
#include "crystal/mesh/mesh_from_obj.h"
#include "crystal/objs.h"
#include "crystal/shapes/notch.h"
#include "crystal/symmetry.h"
#include "random_stream.h"

using namespace parhelion;

namespace {

const std::string kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// "12: what is wrong" of a text that is no crystal; empty where it is one.
std::string complaintOf(const std::string& text) {
  try {
    static_cast<void>(meshFromObj(readObj(text)));
  } catch (const ObjError& error) {
    return std::to_string(error.line()) + ": " + error.what();
  }
  return {};
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string replaced(std::string text, const std::string& part, const std::string& by) {
  return text.replace(text.find(part), part.size(), by);
}

/// A prism's surface in triangles, with so many digits.
std::string roughPrism(int digits) {
  const CrystalMesh prism = hexagonalPrism(0.7);
  std::string text;
  char line[120];
  for (const Vec3& v : prism.vertices()) {
    std::snprintf(line, sizeof line, "v %.*f %.*f %.*f\n", digits, v.x, digits, v.y, digits, v.z);
    text += line;
  }
  for (const Face& face : prism.faces())
    for (std::size_t i = 1; i + 1 < face.vertices.size(); ++i)
      text += "f " + std::to_string(face.vertices[0] + 1) + " " + std::to_string(face.vertices[i] + 1) + " " +
              std::to_string(face.vertices[i + 1] + 1) + "\n";
  return text;
}

}  // namespace

TEST_CASE("an OBJ of a prism is the prism, bit for bit, with the numbers of its groups") {
  for (const double aspect : {0.1, 1.0, 3.0}) {
    const CrystalMesh own = hexagonalPrism(aspect), read = meshFromObj(objOf(own));
    REQUIRE(read.isConvex());
    REQUIRE(read.faces().size() == own.faces().size());
    CHECK(read.volume() == doctest::Approx(own.volume()).epsilon(1e-14));
    for (std::size_t f = 0; f < 8; ++f) {
      CHECK(read.faces()[f].number == own.faces()[f].number);
      CHECK(glm::length(read.faces()[f].normal - own.faces()[f].normal) < 1e-15);
      CHECK(read.faces()[f].offset == doctest::Approx(own.faces()[f].offset).epsilon(1e-15));
    }
  }
}

TEST_CASE("triangles in one plane are one face, and six decimals are enough for parallel faces to be so") {
  const CrystalMesh crystal = meshFromObj(readObj(roughPrism(6)));
  REQUIRE(crystal.isConvex());
  REQUIRE(crystal.faces().size() == 8);
  int pairs = 0;
  for (const Face& face : crystal.faces())
    for (const Face& other : crystal.faces()) pairs += glm::length(face.normal + other.normal) == 0.0;
  CHECK(pairs == 8);
  CHECK(crystal.volume() == doctest::Approx(hexagonalPrism(0.7).volume()).epsilon(1e-5));
}

TEST_CASE("all forms of OBJ that mean the same give the same crystal") {
  const double volume = meshFromObj(readObj(kTetrahedron)).volume();
  CHECK(volume == doctest::Approx(1.0 / 6.0).epsilon(1e-12));
  for (const std::string& text : {replaced(kTetrahedron, "f 1 3 2", "f -4/1/2 -2//7 \\\n  -3 # negative"),
                                  replaced(kTetrahedron, "v 1 0 0", "v +1e0 0 -0 1"),
                                  "# a comment\r\nmtllib x.mtl\nvn 0 0 1\ns off\nusemtl ice\n" + kTetrahedron})
    CHECK(meshFromObj(readObj(text)).volume() == doctest::Approx(volume).epsilon(1e-15));
}

TEST_CASE("what is no crystal is refused with line and reason") {
  CHECK(complaintOf(kTetrahedron).empty());
  CHECK(has(complaintOf(""), "no faces"));
  CHECK(has(complaintOf(std::string("v 0 0 0\0", 8)), "0: this is no text"));
  CHECK(has(complaintOf("solid crystal\n"), "1: 'solid' is no statement"));
  CHECK(has(complaintOf(replaced(kTetrahedron, "v 1 0 0", "v nan 0 0")), "2: a vertex needs three numbers"));
  CHECK(has(complaintOf(replaced(kTetrahedron, "v 1 0 0", "v 1 0")), "2: a vertex needs three numbers"));
  CHECK(has(complaintOf(replaced(kTetrahedron, "f 2 3 4", "f 2 3 5")), "8: this face names vertex 5"));
  CHECK(has(complaintOf(replaced(kTetrahedron, "f 2 3 4", "f 2 3 0")), "8: '0' is no vertex"));
  CHECK(has(complaintOf(replaced(kTetrahedron, "f 2 3 4", "f 2 3 -5")), "8: '-5' is no vertex"));
  CHECK(has(complaintOf(replaced(kTetrahedron, "f 2 3 4\n", "")), "the surface is open"));
  CHECK(has(complaintOf(replaced(kTetrahedron, "f 2 3 4", "f 4 3 2")), "in the same sense"));
  CHECK(has(complaintOf(kTetrahedron + "f 2 3 4\n"), "9: this face and that of line 8"));
  CHECK(has(complaintOf(replaced(kTetrahedron, "v 0 0 1", "v 2 0 0")), "has no area"));
  // All faces turned around.
  CHECK(has(complaintOf("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 2 3 1\nf 4 2 1\nf 3 4 1\nf 4 3 2\n"), "inside out"));
  // A quad that is not planar.
  CHECK(
      has(complaintOf("v 0 0 0\nv 1 0 0\nv 1 1 0.2\nv 0 1 0\nv 0 0 1\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n"),
          "6: this face is not planar"));
  // A bow tie.
  CHECK(has(complaintOf("v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 2 0\nv 0 0 1\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n"),
            "crosses itself"));
  CHECK(has(complaintOf("g 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"),
            "as is that of line 6 in another plane"));
}

TEST_CASE("bodies that cross, touch or lie inside each other are refused, a bubble of air is not") {
  const CrystalMesh prism = hexagonalPrism(1.0), small = hexagonalPrism(0.2);
  const auto complaint = [](const ObjMesh& obj) { return complaintOf(objText(obj)); };
  CHECK(complaint(bothOf(objOf(prism), objOf(small, 3.0, false))).empty());
  CHECK(has(complaint(bothOf(objOf(prism), objOf(small, 1.0, false))), "crosses or touches"));
  CHECK(has(complaint(bothOf(objOf(prism), objOf(prism, 2.0, false))), "same sense"));  // end on end
  ObjMesh inside = objOf(small, 0.0, false);
  for (Vec3& v : inside.vertices) v *= 0.5;
  CHECK(has(complaint(bothOf(objOf(prism), inside)), "inside another one"));
  ObjMesh bubble = inside;
  for (ObjPolygon& polygon : bubble.polygons) std::ranges::reverse(polygon.corners);
  CHECK(complaint(bothOf(objOf(prism), bubble)).empty());
  CHECK(meshFromObj(bothOf(objOf(prism), bubble)).volume() ==
        doctest::Approx(prism.volume() - small.volume() / 8.0).epsilon(1e-12));
}

TEST_CASE("the largest OBJs are read or refused within a second") {
  const auto seconds = [](const std::string& text) {
    const auto start = std::chrono::steady_clock::now();
    CHECK(!complaintOf(text).empty());
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  std::string many = "v 0 0 0\nv 1 0 0\nv 0 1 0\n", slabs, far = "v 0 0 0\n";
  for (int i = 0; i < 200'000; ++i) many += "f 1 2 3\n";
  CHECK(seconds(many) < 1.0);
  CHECK(seconds("f " + std::string(4 << 20, '1')) < 1.0);
  for (int i = 0; i < 300'000; ++i) far += "v 1 2 3\n";
  CHECK(seconds(far) < 1.0);
  // As many open triangles as there may be, all of them above each other.
  for (int i = 0; i < 3000; ++i) {
    const std::string z = std::to_string(i);
    slabs += "v 0 0 " + z + "\nv 1 0 " + z + "\nv 0 1 " + z + "\nf -3 -2 -1\nf -1 -2 -3\n";
  }
  CHECK(seconds(slabs) < 1.0);
}

TEST_CASE("a prism with pits has the volume and the surface of its geometry, and the prism's symmetries") {
  const double aspect = 1.5, depth = 0.4, width = 0.8;
  const CrystalMesh hollow = prismWithEnds(aspect, {{depth, width}}, {{depth, width}}), prism = hexagonalPrism(aspect);
  const double hexagon = 1.5 * std::sqrt(3.0), height = depth * aspect;
  CHECK(hollow.faces().size() == 20);
  CHECK(!hollow.isConvex());
  CHECK(hollow.volume() ==
        doctest::Approx(prism.volume() - 2.0 * hexagon * width * width * height / 3.0).epsilon(1e-13));
  const double slope = std::hypot(height, 0.5 * std::sqrt(3.0) * width);
  CHECK(Crystal{&hollow}.surface() ==
        doctest::Approx(Crystal{&prism}.surface() + 2.0 * (3.0 * width * slope - hexagon * width * width))
            .epsilon(1e-13));
  for (const Isometry& isometry : hexagonalGroup()) CHECK(faceImages(hollow, isometry).has_value());
  const CrystalMesh upper = prismWithEnds(aspect, {{depth, width}}, {});
  int kept = 0;
  for (const Isometry& isometry : hexagonalGroup()) kept += faceImages(upper, isometry).has_value();
  CHECK(kept == 12);
  CHECK_THROWS_AS(prismWithEnds(1.0, {{1.0, 0.5}}, {{1.0, 0.5}}), std::invalid_argument);
}

TEST_CASE("a prism with caps has the volume and the surface of its geometry, and the prism's symmetries") {
  const double aspect = 1.5, hexagon = 1.5 * std::sqrt(3.0);
  const CrystalMesh prism = hexagonalPrism(aspect);
  for (const double width : {2.5, 0.6}) {
    const Cap cap{width, 0.2};
    const CrystalMesh capped = prismWithEnds(aspect, {{}, cap}, {{}, cap});
    const double thick = 2.0 * width * cap.aspect, area = hexagon * width * width;
    CHECK(!capped.isConvex());
    CHECK(capped.volume() == doctest::Approx(prism.volume() + 2.0 * area * thick).epsilon(1e-13));
    const double around = 6.0 * width * thick, ring = std::abs(area - hexagon);
    CHECK(Crystal{&capped}.surface() == doctest::Approx(12.0 * aspect + 2.0 * (area + around + ring)).epsilon(1e-13));
    for (const Isometry& isometry : hexagonalGroup()) CHECK(faceImages(capped, isometry).has_value());
    std::set<int> numbers;
    for (const Face& face : capped.faces()) numbers.insert(face.number);
    std::set<int> expected{1, 2, 3, 4, 5, 6, 7, 8, 53, 54, 55, 56, 57, 58, 63, 64, 65, 66, 67, 68};
    expected.insert(width > 1.0 ? 52 : 51);
    expected.insert(width > 1.0 ? 61 : 62);
    CHECK(numbers == expected);
  }
  // As wide as the prism they make it longer.
  const CrystalMesh longer = prismWithEnds(1.0, {{}, {1.0, 0.25}}, {{}, {1.0, 0.25}}), same = hexagonalPrism(1.5);
  CHECK(longer.isConvex());
  REQUIRE(longer.faces().size() == 8);
  for (const Face& face : longer.faces())
    CHECK(std::ranges::any_of(same.faces(), [&](const Face& other) {
      return other.number == face.number && glm::length(other.normal - face.normal) < 1e-15 &&
             std::abs(other.area - face.area) < 1e-12 && std::abs(other.offset - face.offset) < 1e-12;
    }));
  // One end each: 8 of the prism, 6 of the pit, 7 more of the cap.
  CHECK(prismWithEnds(1.0, {{0.5, 0.8}, {}}, {{}, {2.0, 0.1}}).faces().size() == 8 + 6 + 7);
  CHECK_THROWS_AS(prismWithEnds(1.0, {{0.5, 0.8}, {2.0, 0.1}}, {}), std::invalid_argument);
}

TEST_CASE("a sector plate has the volume and the surface of its geometry, and walls along prism faces where they fit") {
  const double aspect = 0.1, hexagon = 1.5 * std::sqrt(3.0), apothem = 0.5 * std::sqrt(3.0);
  for (const auto& [depth, width] : {std::pair{0.7, 0.3}, std::pair{0.5, 0.5}, std::pair{0.99, 0.99}}) {
    const CrystalMesh plate = notchedPrism(aspect, {depth, width});
    const double area = hexagon - 6.0 * 0.5 * depth * apothem * width;
    const double outline = 6.0 * (1.0 - width + 2.0 * std::hypot(0.5 * width, depth * apothem));
    CHECK(!plate.isConvex());
    CHECK(plate.isPrismatic());
    CHECK(plate.faces().size() == 20);
    CHECK(plate.volume() == doctest::Approx(2.0 * aspect * area).epsilon(1e-12));
    CHECK(Crystal{&plate}.surface() == doctest::Approx(2.0 * area + 2.0 * aspect * outline).epsilon(1e-12));
    for (const Isometry& isometry : hexagonalGroup()) CHECK(faceImages(plate, isometry).has_value());
    int along = 0;
    for (const Face& wall : plate.faces())
      for (const Face& side : plate.faces())
        along +=
            wall.number > 70 && side.number >= 3 && side.number <= 8 && glm::dot(wall.normal, side.normal) > 1 - 1e-12;
    CHECK(along == (depth == width ? 12 : 0));
    // The notch of side 3 is about +x; its first wall is at smaller y and looks to larger y.
    for (const Face& face : plate.faces()) {
      if (face.number == 73) CHECK(face.normal.y > 0.0);
      if (face.number == 83) CHECK(face.normal.y < 0.0);
    }
  }
}

TEST_CASE("caps and notches of any settings are closed or refused, and have the volume that they should") {
  RandomStream random(9, 0, RandomPurpose::path);
  const double hexagon = 1.5 * std::sqrt(3.0);
  const auto between = [&](double least, double most) {
    return std::pow(10.0, least + (most - least) * random.next());
  };
  constexpr int kSets = 3000;
  int refused = 0;
  for (int i = 0; i < kSets; ++i) {
    const double aspect = between(-4, 4);
    const bool isNotched = random.next() < 0.5;
    const Cap cap{between(-2, 2), between(-4, 4)};
    const Notch notch{random.next(), random.next()};
    CAPTURE(aspect);
    CAPTURE(isNotched);
    try {
      const CrystalMesh mesh = isNotched ? notchedPrism(aspect, notch) : prismWithEnds(aspect, {{}, cap}, {});
      const double expected = isNotched
                                  ? hexagon * (1.0 - notch.depth * notch.width) * 2.0 * aspect
                                  : hexagon * (2.0 * aspect + 2.0 * cap.aspect * cap.width * cap.width * cap.width);
      CHECK(mesh.volume() == doctest::Approx(expected).epsilon(1e-5));
    } catch (const std::invalid_argument&) {
      ++refused;
    }
  }
  // What is so thin or so small beside the rest that it has no digits left.
  CHECK(refused < kSets / 4);
}

TEST_CASE("where faces lie in a plane decides on a crystal's symmetry, not only how large they are") {
  // A body and two smaller ones, whose upper ends are in one plane and of one size: turned by half they change places,
  // or do not.
  const CrystalMesh body = hexagonalPrism(0.5), small = hexagonalPrism(0.1);
  const auto bodies = [&](double x, double other) {
    ObjMesh all = objOf(body);
    for (const double at : {x, other}) {
      ObjMesh one = objOf(small, 2.0);
      for (Vec3& v : one.vertices) v += Vec3(at, 0.0, 0.0);
      for (ObjPolygon& polygon : one.polygons) polygon.number.reset();
      all = bothOf(all, one);
    }
    for (ObjPolygon& polygon : all.polygons) polygon.number.reset();
    return meshFromObj(all);
  };
  CHECK(faceImages(bodies(-3.0, 3.0), {.sixths = 3}).has_value());
  CHECK(!faceImages(bodies(-2.5, 3.5), {.sixths = 3}).has_value());
}
