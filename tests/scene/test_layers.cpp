// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "math/conventions.h"
#include "scene_support.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

const std::string kPopulations =
    "[[population]]\nname = 'plates'\norientation = 'plate'\n[[population]]\nname = 'free'\n";

PathSettings pathsOf(const std::string& text) { return parseScene(text, "test").scene.trace.paths; }

Diagnostic errorOf(const std::string& text) {
  const auto errors = errorsOf(text);
  CHECK(errors.size() == 1);
  return errors.at(0);
}

}  // namespace

TEST_CASE("layers are read with their pattern, populations and tilt") {
  const PathSettings paths = pathsOf(kPopulations +
                                     "[[layer]]\nname = 'cza'\npaths = 'circumzenithal arc'\n"
                                     "[[layer]]\nname = 'low'\npopulations = ['plates', 'free']\ntilt = [0, 0.5]\n"
                                     "[trace]\nfilter = 'hits = 1..4'\n");
  REQUIRE(paths.layers.size() == 2);
  CHECK(paths.layers[0].name == "cza");
  CHECK(paths.layers[0].paths->text == "circumzenithal arc");
  CHECK(paths.layers[0].paths->stances == std::vector{Stance::plate});
  CHECK_FALSE(paths.layers[1].paths);
  CHECK(paths.layers[1].populations == std::vector<std::string>{"plates", "free"});
  CHECK(paths.layers[1].tilt->to == doctest::Approx(radians(0.5)));
  CHECK(paths.filter->mostHits == 4);
}

TEST_CASE("layers = \"populations\" is a layer for each") {
  const PathSettings paths = pathsOf("layers = 'populations'\n" + kPopulations);
  REQUIRE(paths.layers.size() == 2);
  CHECK(paths.layers[0].name == "plates");
  CHECK(paths.layers[1].populations == std::vector<std::string>{"free"});
  CHECK(errorOf("layers = 'populations'\n" + kPopulations + "[[layer]]\nname = 'a'\n").line == 1);
  CHECK(errorOf("layers = 'population'\n" + kPopulations).hint == "did you mean 'populations'?");
}

TEST_CASE("a bad pattern is shown with a caret under the place, in files and in overrides") {
  const Diagnostic inFile = errorOf(kPopulations + "[[layer]]\nname = 'a'\npaths = \"3-(5|x)\"\n");
  CHECK(inFile.line == 8);
  CHECK(inFile.column == 15);
  CHECK(inFile.excerpt == "    8 | paths = \"3-(5|x)\"\n      |               ^\n");
  const auto override = [](const std::string& text) {
    try {
      parseScene(kPopulations, "test", std::vector<std::string>{text});
    } catch (const SceneError& error) {
      return error.diagnostics().at(0);
    }
    return Diagnostic{};
  };
  CHECK(override("trace.filter=3-5-").column == 18);
  CHECK(override("trace.filter='3-5-'").column == 19);
  CHECK(override("trace.filter=circumzenithal ark").hint == "did you mean 'circumzenithal arc'?");
  CHECK(override("trace.filter=3-5, symetry = none").hint == "did you mean 'symmetry'?");
  CHECK(override("trace.filter=35").hint.find("prisms have the faces 1 to 8") == 0);
  CHECK(override("trace.filter=9° halo").message == "no crystal here has the faces of '9° halo'");
  CHECK(override("trace.filter=6").message.empty());  // an outside reflection; no crystal here has such a face
  CHECK(errorOf(kPopulations + "[trace]\nfilter = 3.5\n").message.find("a pattern of raypaths") != std::string::npos);
}

TEST_CASE("layers and filters name populations and halos that the scene has") {
  const auto layer = [](const std::string& keys) {
    return errorOf(kPopulations + "[[layer]]\nname = 'a'\n" + keys + "\n");
  };
  CHECK(layer("populations = ['plate']").hint == "did you mean 'plates'?");
  CHECK(layer("populations = ['plate']").line == 8);
  CHECK(layer("paths = '3-5, population = fre'").hint == "did you mean 'free'?");
  CHECK(layer("paths = 'Parry arc'").hint == "it comes of crystals whose orientation is \"parry\"");
  CHECK(layer("paths = 'circumzenithal arc'\npopulations = ['free']").message.find("no population") !=
        std::string::npos);
  CHECK(errorOf(kPopulations + "[trace]\nfilter = 'Lowitz arc'\n").hint.find("lowitz") != std::string::npos);
}

TEST_CASE("a layer has a name that channels of a picture can bear, and that no other has") {
  const auto named = [](const std::string& name) {
    return errorOf(kPopulations + "[[layer]]\nname = '" + name + "'\n").message;
  };
  for (const char* bad : {"rest", "a.b", "a/b", " a", "a "}) CHECK(named(bad).find("must not be") != std::string::npos);
  CHECK(errorOf(kPopulations + "[[layer]]\npaths = '3-5'\n").message == "a layer needs a name");
  CHECK(errorOf(kPopulations + "[[layer]]\nname = 'a'\n[[layer]]\nname = 'a'\n").message ==
        "the name of this layer is taken: \"a\"");
  std::string many = kPopulations;
  for (int i = 0; i < 65; ++i) many += "[[layer]]\nname = 'l" + std::to_string(i) + "'\n";
  CHECK(errorOf(many).message == "65 layers are too many; at most 64");
  CHECK(errorOf(kPopulations + "[[layer]]\nname = 'a'\ntilt = [2, 1]\n").message.find("from below to") !=
        std::string::npos);
}
