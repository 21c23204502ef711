// SPDX-License-Identifier: Apache-2.0
// Haze, and layers by how often light was scattered.
#include <fstream>

#include <doctest/doctest.h>

#include "picture/temporary_directory.h"
#include "scene_support.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

const std::string kCrystals = "[[population]]\n";

std::string hazeOf(const std::string& keys) {
  return kCrystals + "[[population]]\nname = \"h\"\nshape = \"haze\"\n" + keys + "\n";
}

std::string messageOf(const std::string& text) { return errorsOf(text).at(0).message; }

}  // namespace

TEST_CASE("haze stands beside the crystals, with g or a table for its phase function") {
  const Scene scene = sceneOf(hazeOf("g = 0.85\nweight = 3"));
  REQUIRE(scene.hazes.size() == 1);
  CHECK(scene.populations.size() == 1);
  CHECK(scene.hazes[0].name == "h");
  CHECK(scene.hazes[0].weight == 3.0);
  CHECK(std::get<HenyeyGreenstein>(scene.hazes[0].phase).g == 0.85);
  CHECK(std::get<HenyeyGreenstein>(sceneOf(hazeOf("")).hazes[0].phase).g == 0.75);
  const auto table = std::get<PhaseTable>(sceneOf(hazeOf("phase = [[0, 10], [30, 1], [180, 0.5]]")).hazes[0].phase);
  CHECK(table.angles.size() == 3);
  CHECK(table.angles[1] == doctest::Approx(radians(30.0)));
  CHECK(table.values[2] == 0.5);
}

TEST_CASE("a phase function is read from a file beside the scene, and the scene keeps its numbers") {
  const TemporaryDirectory folder;
  const auto load = [&](const std::string& csv) {
    std::ofstream(folder / "ice.csv") << csv;
    std::ofstream(folder / "scene.toml") << hazeOf("phase = \"ice.csv\"");
    return loadScene(folder / "scene.toml");
  };
  const LoadedScene loaded = load("angle,value\r\n# of ice\r\n0,10\r\n30.5, 1\r\n180,5e-1\r\n");
  const auto table = std::get<PhaseTable>(loaded.scene.hazes.at(0).phase);
  CHECK(table.angles.at(1) == doctest::Approx(radians(30.5)));
  CHECK(table.values == std::vector<double>{10.0, 1.0, 0.5});
  CHECK(std::get<PhaseTable>(sceneOf(loaded.text).hazes.at(0).phase).values == table.values);
  for (const char* wrong : {"", "0,1\n", "0,1\n90,x\n180,1\n", "0,1\n90,1\n80,1\n180,1\n", "0,1\n180,-1\n",
                            "5,1\n180,1\n", "0,1\n170,1\n", "0,1\n190,1\n", "0,1 180,1\n"})
    CHECK_THROWS_AS(load(wrong), SceneError);
  CHECK(messageOf(hazeOf("phase = \"none.csv\"")).ends_with("none.csv cannot be read"));
}

TEST_CASE("what haze does not have is refused") {
  CHECK(messageOf(hazeOf("aspect = 1")) == "haze has no 'aspect'");
  CHECK(messageOf(hazeOf("tilt = 1")) == "haze has no 'tilt'");
  CHECK(messageOf(hazeOf("g = 0.5\nphase = [[0, 1], [180, 1]]")) == "'g' cannot be used together with 'phase'");
  CHECK(messageOf(hazeOf("g = 1")).starts_with("'g' must be a number"));
  for (const char* wrong : {"[]", "[[0, 1]]", "[[0, 1], [170, 1]]", "[[0, 1], [0, 1], [180, 1]]", "[[0, 0], [180, 0]]",
                            "[[0, 1], [180, -1]]", "\"file\""})
    CHECK_MESSAGE(messageOf(hazeOf(std::string("phase = ") + wrong)).starts_with("'phase' must be a list"), wrong);
  CHECK(messageOf(kCrystals + "g = 0.5") == "a prism has no 'g'");
  CHECK(messageOf(kCrystals + "phase = [[0, 1], [180, 1]]") == "a prism has no 'phase'");
  CHECK(messageOf("[[population]]\nshape = \"haze\"\n").starts_with("a scene needs a population of crystals"));
  CHECK(messageOf(hazeOf("") + "[[population]]\nname = \"h\"\n") == "the name of this population is taken: \"h\"");
}

TEST_CASE("a layer by order asks for light that the cloud has") {
  const auto layered = [](const std::string& cloud, const std::string& keys) {
    return kCrystals + cloud + "[[layer]]\nname = \"l\"\n" + keys + "\n";
  };
  const std::string twice = "[cloud]\noptical_depth = 1\norders = 2\n";
  const Scene scene = sceneOf(layered(twice, "order = 2"));
  CHECK(scene.trace.paths.layers.at(0).takesOrder(2));
  CHECK_FALSE(scene.trace.paths.layers.at(0).takesOrder(3));
  CHECK_FALSE(sceneOf(layered(twice, "paths = \"3-5\"")).trace.paths.layers.at(0).takesOrder(2));
  CHECK(sceneOf(layered(twice, "")).trace.paths.layers.at(0).takesOrder(2));
  CHECK(messageOf(layered("", "order = 2")) == "this light is not in the picture: its light is scattered once at most");
  CHECK(messageOf(layered(twice, "order = 3")) ==
        "this light is not in the picture: its light is scattered 2 times at most");
  CHECK(messageOf(layered(twice, "order = 2\npaths = \"3-5\"")) ==
        "light that was scattered more than once has no one path, population or tilt");
  CHECK(messageOf(layered(twice, "order = 0")).starts_with("'order' must be"));
  CHECK(messageOf(kCrystals + twice + "[trace]\nfilter = \"3-5\"\n").starts_with("a filter keeps paths through one"));
}

TEST_CASE("a cloud may have layers with populations and depths of their own") {
  const std::string two = hazeOf("") + "[cloud]\norders = 2\n";
  const auto layer = [](const std::string& names, const std::string& depth) {
    return "[[cloud.layer]]\npopulations = [" + names + "]\noptical_depth = " + depth + "\n";
  };
  const std::string crystals = "\"population 1\"", haze = "\"h\"";
  const Scene scene = sceneOf(two + layer(crystals, "0.3") + layer(haze + ", " + crystals, "0.5"));
  REQUIRE(scene.cloud->layers.size() == 2);
  CHECK(scene.cloud->opticalDepth == 0.8);
  CHECK(scene.cloud->layers[1].populations == std::vector<std::string>{"h", "population 1"});
  CHECK(scene.cloud->layers[1].opticalDepth == 0.5);
  // Crystals of each population are in another light.
  REQUIRE(scene.trace.paths.layers.size() == 1);
  CHECK(scene.trace.paths.layers[0].populations == std::vector<std::string>{"population 1"});
  CHECK(sceneOf("layers = \"populations\"\n" + two + layer(crystals + ", " + haze, "1")).trace.paths.layers.size() ==
        1);

  CHECK(messageOf(two + layer(crystals, "0.3")) == "the population \"h\" is in no layer of the cloud");
  CHECK(messageOf(two + layer(crystals + ", " + haze + ", \"x\"", "0.3")) == "there is no population \"x\"");
  CHECK(messageOf(two + layer(crystals + ", " + haze, "-1")).starts_with("'optical_depth' must be a number"));
  CHECK(messageOf(two + "[[cloud.layer]]\noptical_depth = 1\n") == "a layer of a cloud needs 'populations'");
  CHECK(messageOf(two + "[[cloud.layer]]\npopulations = [\"h\"]\n") == "a layer of a cloud needs 'optical_depth'");
  CHECK(messageOf(two + layer("", "1")).starts_with("'populations' must be a list of names"));
  CHECK(messageOf(two + "layer = []\n").starts_with("'layer' must be a list of tables"));
  CHECK(messageOf(two + "optical_depth = 1\n" + layer(crystals + ", " + haze, "1")) ==
        "'optical_depth' cannot be used together with [[cloud.layer]]");
  CHECK(messageOf(two + layer(crystals + ", " + haze, "1") + "[[layer]]\nname = \"l\"\n") ==
        "[[cloud.layer]] cannot be used together with [[layer]]");
  CHECK(messageOf("[[population]]\nweight = 0\n[[population]]\n[cloud]\n" + layer(crystals, "1") +
                  layer("\"population 2\"", "1")) == "all populations of this layer have the weight 0");
}
