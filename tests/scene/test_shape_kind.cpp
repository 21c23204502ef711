// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>
#include <variant>

#include <doctest/doctest.h>

#include "scene/describe.h"
#include "scene/traced_keys.h"
#include "scene_support.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

/// The first complaint about a population, with its hint.
std::string complaint(const std::string& keys) {
  const auto errors = errorsOf("[[population]]\n" + keys);
  REQUIRE(!errors.empty());
  return errors.at(0).message + "; " + errors.at(0).hint;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("sides of prisms and pyramids are read in the order of their faces") {
  const auto triangle = std::get<PrismSettings>(populationWith("sides = [1, 2.5, 1, 2.5, 1, -0.5]").shape);
  CHECK(triangle.sides == Sides{1.0, 2.5, 1.0, 2.5, 1.0, -0.5});
  const auto pyramid =
      std::get<PyramidSettings>(populationWith("shape = 'pyramid'\nsides = [1, 1, 1, 1, 1, 1.5]").shape);
  CHECK(pyramid.sides[5] == 1.5);
  CHECK(std::get<PrismSettings>(populationWith("aspect = 2").shape).sides == kRegularSides);
}

TEST_CASE("ends of pyramids have Miller indices or slopes of their own") {
  const auto p = std::get<PyramidSettings>(
      populationWith("shape = 'pyramid'\nupper = { miller = [2, 0, -2, 1], height = 0.25 }\nlower = { slope = 60 }")
          .shape);
  CHECK(p.upper == 0.25);
  CHECK(degrees(p.upperSlope.value()) == doctest::Approx(14.888).epsilon(1e-4));
  CHECK(p.lower == 0.5);
  CHECK(degrees(p.lowerSlope.value()) == doctest::Approx(60.0));
  const auto slope = [](const std::string& indices) {
    const auto own =
        std::get<PyramidSettings>(populationWith("shape = 'pyramid'\nupper = { miller = [" + indices + "] }").shape);
    return degrees(own.upperSlope.value());
  };
  CHECK(std::abs(slope("1, 0, -1, 1") - 27.999) < 5e-4);
  CHECK(std::abs(slope("1, 0, -1, 2") - 46.760) < 5e-4);
  CHECK(std::abs(slope("3, 0, -3, 2") - 19.518) < 5e-4);
}

TEST_CASE("lengths, heights, slopes and sides may be spread, alone or tied") {
  const auto p = std::get<PyramidSettings>(
      populationWith("shape = 'pyramid'\naspect = { lognormal = [0.4, 0.3] }\n"
                     "upper = { height = { uniform = [0, 1] }, slope = { laplace = [30, 2] } }\n"
                     "lower = { normal = [0.5, 0.1] }\nsides = { threefold = { normal = [1, 0.2] } }")
          .shape);
  REQUIRE(p.spreads.size() == 6);
  CHECK(std::get<LogNormal>(p.spreads[0].distribution).sigma == 0.3);
  CHECK(p.spreads[1].what == ShapeLength::sides);
  CHECK(p.spreads[1].sides == std::array{true, false, true, false, true, false});
  CHECK(p.spreads[2].sides == std::array{false, true, false, true, false, true});
  CHECK(p.spreads[3].what == ShapeLength::upper);
  CHECK(p.spreads[4].what == ShapeLength::upperSlope);
  CHECK(degrees(std::get<Laplace>(p.spreads[4].distribution).mean) == doctest::Approx(30.0));
  CHECK(p.spreads[5].what == ShapeLength::lower);
  const auto prism = [](const std::string& sides) {
    return std::get<PrismSettings>(populationWith("sides = " + sides).shape);
  };
  CHECK(prism("{ normal = [1, 0.1] }").spreads.size() == 6);
  CHECK(prism("{ twofold = { normal = [1, 0.1] } }").spreads.size() == 3);
  CHECK(prism("{ sixfold = { normal = [1, 0.1] } }").spreads.size() == 1);
  const auto log = std::get<PrismSettings>(populationWith("aspect = { lognormal = [0.3, 0.4] }").shape);
  REQUIRE(log.spreads.size() == 1);
  CHECK(log.spreads[0].what == ShapeLength::aspect);
  const auto some = prism("[1, { uniform = [1, 2] }, 1, 1, 1, 0.5]");
  REQUIRE(some.spreads.size() == 1);
  CHECK(some.spreads[0].sides[1]);
  CHECK(some.sides[5] == 0.5);
}

TEST_CASE("planes are read with their numbers and distances, whatever the length of their normals") {
  const auto p = std::get<PlanesSettings>(
      populationWith(
          "shape = 'planes'\nplanes = [{ normal = [0, 0, 7], distance = 2, face = 1 }, { normal = [1, 1, -1] }, "
          "{ normal = [-1, 1, -1] }, { normal = [0, -1, -1], face = 40 }]")
          .shape);
  REQUIRE(p.planes.size() == 4);
  CHECK(p.planes[0].number == 1);
  CHECK(p.planes[0].normal == Vec3(0.0, 0.0, 1.0));
  CHECK(p.planes[0].distance == 2.0);
  CHECK(p.planes[1].number == 2);
  CHECK(p.planes[1].normal.x == doctest::Approx(1.0 / std::sqrt(3.0)).epsilon(1e-15));
  CHECK(p.planes[3].number == 40);
}

TEST_CASE("crystals that cannot be are refused with one error at their key") {
  CHECK(has(complaint("sides = [1, 1, 1]"), "'sides' must be six numbers or distributions, or one distribution"));
  CHECK(has(complaint("sides = [1, 1, 1, 1, 1, 'a']"), "'sides' must be a number from -100 to 100"));
  CHECK(has(complaint("sides = { threfold = 1 }"), "did you mean 'threefold'?"));
  CHECK(has(complaint("sides = { unifrm = [1, 2] }"), "did you mean 'uniform'?"));
  CHECK(has(complaint("sides = { threefold = { normal = [1, 0.1] }, twofold = 1 }"), "tied in one way only"));
  CHECK(has(complaint("sides = { lognormal = [-1, 0.1] }"), "median of a lognormal distribution must be above 0"));
  CHECK(has(complaint("sides = { uniform = [-2, -1] }"), "enclose nothing"));
  CHECK(has(complaint("sides = [1, 1, 1, -2, 1, 1]"), "enclose nothing"));
  CHECK(has(complaint("shape = 'planes'"), "needs 'planes'"));
  CHECK(has(complaint("planes = [{ normal = [0, 0, 1] }]"), "a prism has no 'planes'; it needs shape = \"planes\""));
  CHECK(has(complaint("shape = 'planes'\nplanes = [{ normal = [0, 0, 1] }]"), "do not close"));
  CHECK(has(complaint("shape = 'planes'\nplanes = [{ normal = [0, 0, 0] }]"), "a direction [x, y, z]"));
  CHECK(has(complaint("shape = 'planes'\nplanes = [{ distance = 1 }]"), "needs a 'normal'"));
  CHECK(has(complaint("shape = 'planes'\nplanes = [{ normal = [1, 0, 0], face = 2 }, { normal = [0, 1, 0] }]"),
            "two planes are face 2"));
  CHECK(has(complaint("shape = 'planes'\nplanes = []"), "a list of planes"));
  CHECK(has(complaint("shape = 'pyramid'\nupper = { miller = [1, 0, 1, 1] }"), "Miller indices [h, 0, -h, l]"));
  CHECK(has(complaint("shape = 'pyramid'\nupper = { miller = [1, 0, -1, 1], slope = 3 }"), "leave one of them out"));
  CHECK(has(complaint("shape = 'pyramid'\nupper = { hieght = 1 }"), "did you mean 'height'?"));
  CHECK(has(complaint("upper = 0.5"), "a prism has no 'upper'; it needs shape = \"pyramid\""));
  CHECK(errorsOf("[[population]]\nsides = [1, 1, 1, -2, 1, 1]").size() == 1);
}

TEST_CASE("sides, slopes and planes are told in a summary and in what identifies a run") {
  const auto sceneOfCrystal = [](const std::string& keys) { return sceneOf("[[population]]\n" + keys); };
  CHECK(has(describeScene(sceneOfCrystal("sides = [1, 2, 1, 2, 1, 2]")), "sides 1, 2, 1, 2, 1, 2"));
  CHECK(!has(describeScene(sceneOfCrystal("")), "sides"));
  CHECK(has(describeScene(sceneOfCrystal("shape = 'pyramid'\nupper = { slope = 60 }")), "upper 0.5 at 60°"));
  const auto hash = [&](const std::string& keys) {
    const Scene scene = sceneOfCrystal(keys);
    return hashOf(tracedKeys(scene, scene.trace));
  };
  CHECK(hash("sides = [1, 1, 1, 1, 1, 1]") == hash(""));
  CHECK(hash("sides = [1, 2, 1, 2, 1, 2]") != hash(""));
  CHECK(hash("shape = 'pyramid'\nupper = { slope = 60 }") != hash("shape = 'pyramid'\nlower = { slope = 60 }"));
}
