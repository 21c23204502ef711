// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "crystal/isometry.h"
#include "crystal/population.h"
#include "crystal/raypath/halo_paths.h"
#include "crystal/raypath/path_automaton.h"
#include "crystal/raypath/path_code.h"
#include "crystal/raypath/path_symmetry.h"
#include "random_stream.h"

using namespace parhelion;

namespace {

const CrystalMesh& prism() {
  static const CrystalMesh mesh = hexagonalPrism(1.0);
  return mesh;
}

AxisOrientation plate() { return {Normal{0.0, radians(1)}}; }
AxisOrientation column() { return {Normal{0.5 * kPi, radians(1)}}; }
AxisOrientation parry() {
  return {Normal{0.5 * kPi, radians(1)}, UniformRange{0.0, 2.0 * kPi}, Normal{0.0, radians(1)}};
}

std::size_t orderOf(const OrientationSettings& orientation, PathSymmetry symmetry = PathSymmetry::orientation,
                    const CrystalMesh& mesh = prism()) {
  return pathSymmetries(mesh, orientation, symmetry).size();
}

std::vector<int> numbersOf(const CrystalMesh& mesh) {
  std::vector<int> numbers;
  for (const Face& face : mesh.faces()) numbers.push_back(face.number);
  return numbers;
}

/// Whether a pattern takes a path given by face numbers.
bool takes(const std::string& text, const std::vector<int>& path, const OrientationSettings& orientation = plate(),
           const CrystalMesh& mesh = prism()) {
  const PathPattern pattern = parsePathPattern(text);
  const std::vector<int> numbers = numbersOf(mesh);
  const SymmetricPattern patterns[] = {{&pattern, pathSymmetries(mesh, orientation, pattern.symmetry)}};
  std::vector<int> faces;
  for (const int number : path) faces.push_back(static_cast<int>(std::ranges::find(numbers, number) - numbers.begin()));
  return PathAutomaton(numbers, patterns).acceptedAfter(faces)[0];
}

/// All images of a path.
std::set<std::vector<int>> classOf(std::vector<int> path, const OrientationSettings& orientation,
                                   PathSymmetry symmetry) {
  std::set<std::vector<int>> images;
  for (const std::vector<int>& image : pathSymmetries(prism(), orientation, symmetry)) {
    std::vector<int> moved;
    for (const int number : path) moved.push_back(prism().faces()[image[number - 1]].number);
    images.insert(moved);
  }
  return images;
}

std::size_t placeOfError(const std::string& text) {
  try {
    parsePathPattern(text);
  } catch (const PatternError& error) {
    return error.at;
  }
  return std::string::npos;
}

}  // namespace

TEST_CASE("the isometries of the hexagonal prism are a group of order 24, half of them rotations") {
  const auto group = hexagonalGroup();
  const Vec3 v(0.3, 0.5, 0.7);
  std::set<std::vector<long>> images;
  int proper = 0;
  for (const Isometry& one : group) {
    const Vec3 a = one(v);
    images.insert({std::lround(a.x * 1e9), std::lround(a.y * 1e9), std::lround(a.z * 1e9)});
    proper += one.isProper();
    const Mat3 matrix(one(Vec3(1, 0, 0)), one(Vec3(0, 1, 0)), one(Vec3(0, 0, 1)));
    CHECK(glm::determinant(matrix) == doctest::Approx(one.isProper() ? 1.0 : -1.0));
  }
  CHECK(images.size() == 24);
  CHECK(proper == 12);
  for (const Isometry& first : group)
    for (const Isometry& second : group) {
      const Vec3 both = second(first(v));
      CHECK(images.contains({std::lround(both.x * 1e9), std::lround(both.y * 1e9), std::lround(both.z * 1e9)}));
    }
}

TEST_CASE("paths have the symmetry that crystal and orientation leave: 24, 12 for plates, 4 for Parry columns") {
  CHECK(orderOf(RandomOrientation{}) == 24);
  CHECK(orderOf(plate()) == 12);
  CHECK(orderOf(column()) == 24);
  CHECK(orderOf(parry()) == 4);
  CHECK(orderOf(LowitzOrientation{}) == 8);
  CHECK(orderOf(LowitzOrientation{FixedValue{0.5 * kPi}, Normal{0.0, radians(20)}}) == 4);
  CHECK(orderOf(parry(), PathSymmetry::crystal) == 24);
  CHECK(orderOf(RandomOrientation{}, PathSymmetry::none) == 1);
  CHECK(orderOf(RandomOrientation{}, PathSymmetry::crystal, hexagonalPyramid({0.5, 0.5, 0.3})) == 12);
  CHECK(orderOf(RandomOrientation{}, PathSymmetry::crystal, hexagonalPyramid({0.5, 0.4, 0.4})) == 24);
}

TEST_CASE("classes of paths have the sizes that group theory gives") {
  CHECK(classOf({3, 5}, RandomOrientation{}, PathSymmetry::orientation).size() == 12);
  CHECK(classOf({1, 3}, RandomOrientation{}, PathSymmetry::orientation).size() == 12);
  CHECK(classOf({1, 3}, plate(), PathSymmetry::orientation).size() == 6);
  CHECK(classOf({3, 1, 5}, column(), PathSymmetry::orientation).size() == 24);
  CHECK(classOf({3, 5}, parry(), PathSymmetry::orientation).size() == 2);
  CHECK(classOf({1}, plate(), PathSymmetry::orientation).size() == 1);
  CHECK(classOf({1, 2}, RandomOrientation{}, PathSymmetry::none).size() == 1);
  CHECK(classOf({1, 3, 4, 2}, plate(), PathSymmetry::orientation).size() == 12);
}

TEST_CASE("patterns take what they say: chains, classes, alternatives, counts") {
  const RandomOrientation random;
  CHECK(takes("3-5", {4, 6}, random));
  CHECK(takes("3-5", {3, 7}, random));
  CHECK_FALSE(takes("3-5", {3, 6}, random));
  CHECK_FALSE(takes("3-5", {3, 5, 7}, random));
  CHECK_FALSE(takes("3-5", {3}, random));
  CHECK(takes("3-5, symmetry = none", {3, 5}));
  CHECK_FALSE(takes("3-5, symmetry = none", {3, 7}));
  CHECK(takes("1-3", {1, 8}));
  CHECK_FALSE(takes("1-3", {2, 8}));
  CHECK(takes("1-3; symmetry=crystal", {2, 8}));
  CHECK(takes("*", {3}));
  CHECK(takes("?-?", {3, 1}));
  CHECK_FALSE(takes("?-?", {3}));
  CHECK(takes("3-*-5", {3, 5}));
  CHECK(takes("3-*-5", {3, 1, 2, 5}));
  CHECK_FALSE(takes("3-*-5, symmetry = none", {3, 1, 2, 6}));
  CHECK(takes("*-basal-*", {3, 1, 5}));
  CHECK_FALSE(takes("*-basal-*", {3, 5}));
  CHECK(takes("prism-upper-prism", {3, 1, 5}));
  CHECK_FALSE(takes("prism-upper-prism", {3, 2, 5}));
  CHECK(takes("(3-5 | 3-7)-1, symmetry = none", {3, 7, 1}));
  CHECK(takes("3-(5|1-*)-7, symmetry = none", {3, 1, 2, 1, 7}));
  CHECK(takes("hits = 2..3", {3, 5}));
  CHECK_FALSE(takes("hits = 2..3", {3}));
  CHECK_FALSE(takes("hits=2..3", {3, 1, 2, 5}));
  CHECK(takes("hits = 4..", {3, 1, 2, 5}));
  CHECK(takes("hits = ..2", {3}));
  CHECK(takes("entry = basal, exit = prism, hits = 3", {1, 4, 6}));
  CHECK_FALSE(takes("entry = basal, exit = prism, hits = 3", {1, 4, 2}));
  CHECK_FALSE(takes("entry = 1 | 3, symmetry = none", {2, 3}));
  CHECK(takes("entry = 3, exit = 5, symmetry = orientation", {3, 7}));        // as mirror images
  CHECK_FALSE(takes("entry = 3, exit = 5, symmetry = orientation", {3, 6}));  // entry and exit move together
  CHECK(takes("not 3-5", {3, 6}));
  CHECK_FALSE(takes("not 3-5", {3, 5}));
  CHECK(takes("22° halo", {3, 5}, random));
  CHECK(takes("22 deg Halo", {4, 6}, random));
  CHECK(takes("circumzenithal arc, hits = 2", {1, 5}));
  for (const char* name : {"sundog", "sun dogs", "mock suns", "Parhelia"})
    CHECK(parsePathPattern(name).places.size() == parsePathPattern("parhelion").places.size());
  CHECK(parsePathPattern("22 halo").stances == std::vector{Stance::random});
  for (const char* name : {"CZA", "CHA", "UTA", "120 parhelia", "diffuse arcs", "helic arc"})
    CHECK_FALSE(parsePathPattern(name).stances.empty());
  // Each alternative to a name has the stances of its own crystals, or any.
  const PathPattern mixed = parsePathPattern("22° halo | 3-(1 | 2)-5 | CZA, hits = 2..3");
  REQUIRE(mixed.others.size() == 2);
  CHECK(mixed.stances == std::vector{Stance::random});
  CHECK(mixed.others[0].stances.empty());
  CHECK(mixed.others[0].mostHits == 3);
  CHECK(mixed.others[1].stances == std::vector{Stance::plate});
  CHECK(takes("Parry arc", {5, 7}, parry()));
  CHECK_FALSE(takes("3-5", {5, 7}, parry()));
  const CrystalMesh pyramid = hexagonalPyramid({0.5, 0.4, 0.4});
  CHECK(takes("pyramid-prism", {16, 3}, random, pyramid));
  CHECK(takes("9° halo", {26, 3}, random, pyramid));
}

TEST_CASE("all names of halos are patterns, of which each stance has one") {
  std::set<std::pair<std::string_view, Stance>> names;
  for (const HaloPath& halo : haloPaths()) {
    CAPTURE(halo.name);
    for (const Stance stance : halo.stances) CHECK(names.insert({halo.name, stance}).second);
    const auto named = halosNamed(halo.name);
    CHECK(std::ranges::find(named, &halo) != named.end());
    CHECK_FALSE(parsePathPattern(halo.pattern).places.empty());
    CHECK(parsePathPattern(halo.name).stances == named.front()->stances);
    CHECK(parsePathPattern(halo.name).others.size() + 1 == named.size());
    CHECK_FALSE(halo.source.empty());
  }
}

TEST_CASE("a bad pattern is refused at the place where it is bad") {
  CHECK(placeOfError("3-") == 2);
  CHECK(placeOfError("3--5") == 2);
  CHECK(placeOfError("3-(5|7") == 6);
  CHECK(placeOfError("3-5)") == 3);
  CHECK(placeOfError("3-x") == 2);
  CHECK(placeOfError("3-1000") == 2);
  CHECK(placeOfError("3-0") == 2);
  CHECK(placeOfError("3-5 5") == 4);
  CHECK(placeOfError("3-5, hits = 4..2") == 12);
  CHECK(placeOfError("3-5, hits = 256") == 12);
  CHECK(placeOfError("3-5, hitz = 2") == 5);
  CHECK(placeOfError("3-5, symmetry = all") == 16);
  CHECK(placeOfError("3-5, population = 'a") == 18);
  CHECK(placeOfError("circumzenithal ark") == 0);
  CHECK(placeOfError("CZA | 3-x") == 8);
  CHECK(placeOfError("CZA | ark, hits = 2") == 6);
  CHECK(placeOfError("CZA | 3-5 5") == 10);
  CHECK(placeOfError("-3") == 0);
  CHECK(placeOfError("not") == 3);
  CHECK(placeOfError(" ") == 1);
  CHECK(placeOfError("") == 0);
  CHECK(placeOfError("3-99999999999999999999") == 2);
  CHECK(placeOfError(std::string(1000, '(')) == static_cast<std::size_t>(kDeepestPattern) + 1);
}

TEST_CASE("paths of any length are coded by their first and last faces") {
  for (const int faces : {8, 20, 32}) {
    const PathCode code(faces);
    CAPTURE(faces);
    RandomStream random(7, 0, RandomPurpose::path);
    for (const int count : {1, 2, code.room(), code.room() + 1, 2 * code.room(), 2 * code.room() + 1, 500}) {
      PathCode::Words words;
      std::vector<int> path;
      for (int i = 0; i < count; ++i) {
        path.push_back(static_cast<int>(random.next() * faces));
        words = code.with(words, path.back(), i);
      }
      const PathCode::Faces back = code.faces(words, count);
      CHECK(static_cast<int>(back.first.size() + back.last.size()) + back.leftOut == count);
      CHECK(std::equal(back.first.begin(), back.first.end(), path.begin()));
      CHECK(std::equal(back.last.rbegin(), back.last.rend(), path.rbegin()));
      CHECK((back.leftOut > 0) == (count > 2 * code.room()));
    }
  }
}
