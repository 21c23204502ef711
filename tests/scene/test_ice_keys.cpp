// SPDX-License-Identifier: Apache-2.0
// What crystals are made of.
#include <fstream>

#include <doctest/doctest.h>

#include "optics/ice.h"
#include "picture/temporary_directory.h"
#include "scene/describe.h"
#include "scene_support.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

std::string ice(const std::string& index) { return "ice.index = " + index + "\n[[population]]\n"; }

std::string messageOf(const std::string& index, const std::string& more = "") {
  const auto errors = errorsOf(more + ice(index));
  REQUIRE(errors.size() == 1);
  CHECK(errors[0].line == 1 + std::count(more.begin(), more.end(), '\n'));
  return errors[0].message;
}

double indexAt(const std::string& index, double wavelength) {
  return refractiveIndex(sceneOf(ice(index)).ice, wavelength);
}

}  // namespace

TEST_CASE("an index is a material's, by a formula, or from a table") {
  CHECK(indexAt("'salt'", 589.3) == doctest::Approx(1.5441).epsilon(1e-4));
  CHECK(indexAt("{ sellmeier = [[0.7, 0.01], [0.1, 80]] }", 500.0) ==
        doctest::Approx(std::sqrt(1.0 + 0.7 * 0.25 / 0.24 + 0.1 * 0.25 / (0.25 - 80.0))));
  CHECK(indexAt("{ sellmeier = [[0.7, 0.01]], constant = 1.1 }", 500.0) ==
        doctest::Approx(std::sqrt(1.1 + 0.7 * 0.25 / 0.24)));
  CHECK(indexAt("{ cauchy = [1.3, 0.004] }", 500.0) == doctest::Approx(1.316));
  CHECK(indexAt("{ table = [[400, 1.33], [700, 1.30]] }", 550.0) == doctest::Approx(1.315));
  const auto table = std::get<IndexTable>(sceneOf(ice("{ table = [[400, 1.33, 1e-9], [700, 1.3, 2e-8]] }")).ice.index);
  CHECK(table.hasK);
  CHECK(table.nodes.at(1).k == 2e-8);
  CHECK(describeScene(sceneOf(ice("'co2-ice'"))).find("index of CO2 ice, Warren 1986") != std::string::npos);
  CHECK(describeScene(sceneOf(ice("{ table = [[400, 1.33], [700, 1.30]] }"))).find("table of 2 rows") !=
        std::string::npos);
}

TEST_CASE("an index is read from a file beside the scene, and the scene keeps its numbers") {
  const TemporaryDirectory folder;
  const auto load = [&](const std::string& csv) {
    std::ofstream(folder / "nacl.csv") << csv;
    std::ofstream(folder / "scene.toml") << ice("'nacl.csv'");
    return loadScene(folder / "scene.toml");
  };
  const LoadedScene loaded = load("wavelength,n,k\r\n# at 20 degrees\r\n400,1.33,0\r\n700, 1.3, 1e-8\r\n");
  CHECK(refractiveIndex(loaded.scene.ice, 550.0) == doctest::Approx(1.315));
  CHECK(std::get<IndexTable>(loaded.scene.ice.index).nodes.at(1).k == 1e-8);
  CHECK(refractiveIndex(sceneOf(loaded.text).ice, 550.0) == refractiveIndex(loaded.scene.ice, 550.0));
  for (const char* wrong :
       {"", "wavelength,n\n", "400\n", "400,1.3,0,0\n", "400,1.3\n400,1.2\n", "400,1.3\n300,1.2\n",
        "400,1.0\n700,1.3\n", "400,3.1\n", "400,1.3,-1e-9\n700,1.3,0\n", "400,1.3,0\n700,1.3\n", "400,1.3\n700,nan\n",
        "400,1.3\n700,x\n", "-1,1.3\n", "3OO,1.6\n400,1.3\n700,1.3\n", "400;1.6\n400,1.3\n700,1.3\n",
        "nm,n\nnm,n\n400,1.3\n700,1.3\n", "400,,1.3\n", "400,1.3,\n", "400,1.3,inf\n"})
    CHECK_THROWS_AS_MESSAGE(load(wrong), SceneError, wrong);
  for (const char* right :
       {"400,1.3\n\n700,1.3\n", "# measured\n\nnm,n\n400,1.3\n700,1.3\n", "  # measured\n400, 1.3\n 700 ,\t1.3 \r\n"})
    CHECK_NOTHROW_MESSAGE(load(right), right);
  CHECK(messageOf("'none.csv'").ends_with("none.csv cannot be read"));
}

TEST_CASE("a file's fault is told with its line") {
  const TemporaryDirectory folder;
  std::ofstream(folder / "a.csv") << "nm,n\n400,1.33\n450,1.32\n440,1.31\n";
  std::ofstream(folder / "scene.toml") << ice("'a.csv'");
  try {
    loadScene(folder / "scene.toml");
    FAIL("no error");
  } catch (const SceneError& error) {
    REQUIRE(error.diagnostics().size() == 1);
    CHECK(error.diagnostics()[0].message.find("a.csv, line 4: must be wavelength,n") != std::string::npos);
    CHECK(error.diagnostics()[0].message.ends_with(", not '440,1.31'"));
    CHECK(error.diagnostics()[0].line == 1);
  }
}

TEST_CASE("a table must cover the light of its scene, and the ends' values hold beyond") {
  CHECK(messageOf("{ table = [[450, 1.33], [650, 1.30]] }") ==
        "the index is known from 450 to 650 nm, and needed from 400 to 700 nm");
  CHECK(messageOf("{ table = [[450, 1.33], [650, 1.30]] }", "sun.spectrum = [440, 600]\n") ==
        "the index is known from 450 to 650 nm, and needed from 440 to 600 nm");
  CHECK(errorsOf("sun.spectrum = [450, 600]\n" + ice("{ table = [[450, 1.33], [650, 1.30]] }")).empty());
  CHECK(errorsOf("sun.spectrum = 550\n" + ice("{ table = [[550, 1.33]] }")).empty());
  CHECK(errorsOf(ice("{ table = [[400, 1.33], [700, 1.30]] }")).empty());
}

TEST_CASE("a formula must give an index above 1 and at most 3 at all wavelengths of the light") {
  CHECK(messageOf("{ cauchy = [1.3, 4000] }").starts_with("the index at 360 nm must be above 1 and at most 3, not "));
  CHECK(messageOf("{ cauchy = [0.5] }", "sun.spectrum = 600\n") ==
        "the index at 600 nm must be above 1 and at most 3, not 0.5");
  CHECK(messageOf("{ sellmeier = [[-2, 0.01]] }").ends_with("nan"));
  CHECK(messageOf("{ sellmeier = [[1, 0.25]] }").starts_with("the index at 360 nm"));  // a resonance at 500 nm
}

TEST_CASE("what is no index is refused in one line") {
  CHECK(messageOf("{}").starts_with("an index needs one of"));
  CHECK(messageOf("{ cauchy = [1.3], table = [[400, 1.3], [700, 1.3]] }").starts_with("an index needs one of"));
  CHECK(messageOf("{ cauchy = [1.3], constant = 1 }") == "'constant' belongs to 'sellmeier'");
  CHECK(messageOf("{ cauchy = [] }").starts_with("'cauchy' must be a list of 1 to 16 numbers"));
  CHECK(messageOf("{ cauchy = 1.3 }").starts_with("'cauchy' must be a list"));
  CHECK(messageOf("{ sellmeier = [0.7, 0.01] }").starts_with("'sellmeier' must be a list of 1 to 16 pairs"));
  CHECK(messageOf("{ sellmeier = [[0.7]] }").starts_with("'sellmeier' must be a list of 1 to 16 pairs"));
  CHECK(messageOf("{ sellmeier = [[0.7, 0.01]], constant = -1 }").starts_with("'constant' must be a number"));
  for (const char* wrong : {"[]", "[[400]]", "[[400, 1.3], [300, 1.3]]", "[[400, 1.3, -1], [700, 1.3, 0]]",
                            "[[400, 1.3, 0], [700, 1.3]]", "[[400, 0.9], [700, 1.3]]", "5"})
    CHECK_MESSAGE(messageOf(std::string("{ table = ") + wrong + " }").starts_with("'table' must be a list of rows"),
                  wrong);
  CHECK(messageOf("{ caucy = [1.3] }").starts_with("unknown key 'caucy'"));
  CHECK(messageOf("[]").starts_with("'index' must be one of"));
  CHECK(errorsOf(ice("'co2-ic'")).at(0).hint == "did you mean 'co2-ice'?");
}

TEST_CASE("absorption is off, a material's own, or a number") {
  const std::string sized = "[[population]]\nsize = 300\n";
  CHECK_FALSE(sceneOf("[[population]]\n").ice.absorbs);
  CHECK_FALSE(sceneOf("ice.absorption = false\n" + sized).ice.absorbs);
  const IceSettings own = sceneOf("ice.absorption = true\n" + sized).ice;
  CHECK(own.absorbs);
  CHECK(imaginaryIndex(own, 550.0) == doctest::Approx(2.289e-9));  // Warren & Brandt 2008
  const IceSettings grey = sceneOf("ice.absorption = 1e-6\n" + sized).ice;
  CHECK(grey.absorbs);
  CHECK(imaginaryIndex(grey, 400.0) == 1e-6);
  const IceSettings table =
      sceneOf("[ice]\nindex = { table = [[400, 1.33, 0], [700, 1.3, 3e-8]] }\nabsorption = true\n" + sized).ice;
  CHECK(imaginaryIndex(table, 500.0) == doctest::Approx(1e-8));
  CHECK(imaginaryIndex(table, 800.0) == 3e-8);
  const PopulationSettings some =
      populationWith("size = { lognormal = [100, 0.5] }\ndiffraction = true\ndistortion = 2");
  CHECK(std::get<LogNormal>(*some.size).median == 100.0);
  CHECK(some.diffracts);
  CHECK(some.distortion == doctest::Approx(radians(2)));
}

TEST_CASE("absorption and diffraction of what is not known is refused in one line") {
  const auto first = [](const std::string& text) {
    const auto errors = errorsOf(text);
    REQUIRE(errors.size() == 1);
    return errors[0].message;
  };
  const std::string sized = "[[population]]\nsize = 300\n";
  CHECK(first("ice.absorption = -1e-6\n" + sized)
            .starts_with("'absorption' must be true, false or a number from 0 to 0.1"));
  CHECK(first("ice.absorption = 'yes'\n" + sized).starts_with("'absorption' must be"));
  CHECK(first("[ice]\nindex = 'salt'\nabsorption = true\n" + sized) == "how much this material absorbs is not known");
  CHECK(first("[ice]\nindex = 1.31\nabsorption = true\n" + sized) == "how much this material absorbs is not known");
  CHECK(errorsOf("[ice]\nindex = 1.31\nabsorption = 1e-6\n" + sized).empty());
  CHECK(first("ice.absorption = true\n[[population]]\n") == "'absorption' of [ice] needs the 'size' of these crystals");
  CHECK(errorsOf("ice.absorption = true\n" + sized + "[[population]]\nshape = 'haze'\n").empty());
  CHECK(first("[[population]]\ndiffraction = true\n") == "'diffraction' needs the 'size' of the crystals");
  CHECK(first(sized) == "'size' changes nothing without 'diffraction', or 'absorption' of [ice]");
  CHECK(errorsOf(sized + "diffraction = false\n").empty());
  CHECK(errorsOf("ice.absorption = false\n" + sized).empty());
  CHECK(first("[[population]]\nsize = 0\ndiffraction = true\n")
            .starts_with("'size' must be a number from 0.1 to 100000"));
  CHECK(first("[[population]]\ndistortion = -1\n") == "'distortion' must be a number from 0 to 30 degrees, not -1");
  CHECK(first("[[population]]\ndiffraction = 30\n") == "'diffraction' must be true or false, not 30");
  CHECK(first("[[population]]\n[[population]]\nshape = 'haze'\nsize = 3\n") == "haze has no 'size'");
}
