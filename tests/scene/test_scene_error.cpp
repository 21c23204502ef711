// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "scene_support.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

using Lines = std::vector<std::string>;

/// Errors of a scene with these tables and a population that is all right.
Lines wrong(const std::string& tables) { return linesOf(errorsOf(tables + "\n[[population]]")); }

/// Errors of a scene whose first line is [[population]].
Lines wrongPopulation(const std::string& keys) { return linesOf(errorsOf("[[population]]\n" + keys)); }

}  // namespace

TEST_CASE("numbers out of range are shown with the range") {
  CHECK(wrong("[sun]\nelevation = 250") == Lines{"2:13 'elevation' must be a number from -90 to 90 degrees, not 250"});
  CHECK(wrong("[sun]\ndiameter = -1") == Lines{"2:12 'diameter' must be a number from 0 to 10 degrees, not -1"});
  CHECK(wrong("ice.index = 1.0") ==
        Lines{"1:13 'index' must be one of \"warren-brandt\", \"cubic-ice\", \"co2-ice\", \"ammonia-ice\", "
              "\"salt\", \"water\", a number above 1 and at most 3, a list of such, { sellmeier = […] }, "
              "{ cauchy = […] } or the name of a .csv file, not 1"});
  CHECK(wrongPopulation("weight = -1") == Lines{"2:10 'weight' must be a number from 0 to 1000000000, not -1"});
  CHECK(wrongPopulation("shape = 'pyramid'\nslope = 90") ==
        Lines{"3:9 'slope' must be a number above 0 and below 90 degrees, not 90"});
  CHECK(wrongPopulation("shape = 'pyramid'\nupper = 1.5") ==
        Lines{"3:9 'upper' must be a number from 0 to 1, not 1.5"});
  CHECK(wrong("[trace]\nseed = -1") == Lines{"2:8 'seed' must be an integer, at least 0, not -1"});
}

TEST_CASE("NaN and infinity are never numbers of a scene") {
  CHECK(wrong("[sun]\nelevation = nan") == Lines{"2:13 'elevation' must be a number from -90 to 90 degrees, not nan"});
  CHECK(wrongPopulation("weight = inf") == Lines{"2:10 'weight' must be a number from 0 to 1000000000, not inf"});
  CHECK(wrong("[trace]\nrays = nan").size() == 1);
  CHECK(wrong("[sun]\nspectrum = [nan]").size() == 1);
  CHECK(wrongPopulation("aspect = nan").size() == 1);
  CHECK(wrongPopulation("aspect = { uniform = [1, inf] }") ==
        Lines{"2:26 'to' must be a number from 0.0001 to 10000, not inf"});
  CHECK(wrongPopulation("orientation = 'plate'\ntilt = nan").size() == 1);
}

TEST_CASE("a value of the wrong kind is told with what was expected") {
  CHECK(wrong("[sun]\nelevation = '20'") ==
        Lines{"2:13 'elevation' must be a number from -90 to 90 degrees, not the string \"20\""});
  CHECK(wrong("[sun]\nvisible = 1") == Lines{"2:11 'visible' must be true or false, not 1"});
  CHECK(wrong("sun = 3") == Lines{"1:7 'sun' must be a table, not 3"});
  CHECK(wrong("[[sun]]") == Lines{"1:1 'sun' must be a table, not a list"});
  CHECK(wrong("camera = 2020-01-01") == Lines{"1:10 'camera' must be a table, not a date alone"});
  CHECK(wrong("[trace]\nengine = true") == Lines{"2:10 'engine' must be one of \"embree\", \"embree-robust\", "
                                                 "\"planes\", \"auto\", \"integral\", \"mixed\", not true"});
  CHECK(wrong("[trace]\nseed = 1.5") == Lines{"2:8 'seed' must be an integer, at least 0, not 1.5"});
}

TEST_CASE("wavelengths are visible and listed once") {
  CHECK(wrong("[sun]\nspectrum = [450, 900]") ==
        Lines{"2:18 'spectrum' must be a list of wavelengths from 360 to 830 nm here, not 900"});
  CHECK(wrong("[sun]\nspectrum = [450, 550, 450.0]") == Lines{"2:23 the wavelength 450 nm is listed twice"});
  CHECK(wrong("[sun]\nspectrum = []").size() == 1);
  CHECK(wrong("[sun]\nspectrum = {}") == Lines{"2:12 a spectrum's table needs 'wavelengths' or 'blackbody'"});
  CHECK(wrong("[sun]\nspectrum = { wavelengths = [450, 550], weights = [1] }") ==
        Lines{"2:50 1 'weights' for 2 'wavelengths'; each needs one"});
  CHECK(wrong("[sun]\nspectrum = { wavelengths = [450, 550], weights = [1, 0] }") ==
        Lines{"2:54 'weights' must be a list of numbers above 0 and at most 1000000000 here, not 0"});
  CHECK(wrong("[sun]\nspectrum = { weights = [1] }").size() == 1);
  CHECK(wrong("[sun]\nspectrum = { wavelengths = [450], blackbody = 3000 }") ==
        Lines{"2:28 a black body has no 'wavelengths'"});
  CHECK(wrong("[sun]\nspectrum = { blackbody = 20 }") ==
        Lines{"2:26 'blackbody' must be a number from 500 to 1000000 K, not 20"});
  CHECK(wrong("[sun]\nspectrum = { blackbdy = 3000 }") == Lines{"2:14 unknown key 'blackbdy' in the spectrum"});
  CHECK(wrong("[sun]\nspectrum = 100").size() == 1);
}

TEST_CASE("impossible distributions are refused") {
  CHECK(wrongPopulation("aspect = { normal = [0, 0.1] }") ==
        Lines{"2:22 'mean' must be a number from 0.0001 to 10000, not 0"});
  CHECK(wrongPopulation("aspect = { normal = [1, -0.1] }") ==
        Lines{"2:25 'sigma' must be a number from 0 to 10000, not -0.1"});
  CHECK(wrongPopulation("aspect = { uniform = [2, 1] }") == Lines{"2:22 the range ends before it begins"});
  CHECK(wrongPopulation("aspect = { normal = 1 }") == Lines{"2:21 'normal' must be [mean, sigma], not 1"});
  CHECK(wrongPopulation("aspect = { arcsine = [1, 1] }").size() == 1);
  CHECK(wrongPopulation("aspect = { normal = [1, 1], uniform = [1, 2] }").size() == 1);
  CHECK(wrongPopulation("orientation = 'plate'\ntilt = -1").size() == 1);
  CHECK(wrongPopulation("orientation = 'plate'\ntilt = { arcsine = -1 }") ==
        Lines{"3:20 'arcsine' must be a number from 0 to 180, not -1"});
}

TEST_CASE("shapes refuse each other's keys") {
  CHECK(wrongPopulation("upper = 0.5") == Lines{"2:9 a prism has no 'upper'"});
  CHECK(wrongPopulation("shape = 'pyramid'\nplanes = [{ normal = [1, 0, 0] }]") ==
        Lines{"3:10 a pyramid has no 'planes'"});
  CHECK(wrongPopulation("shape = 'pyramid'\naspect = 0\nupper = 0\nlower = 0") ==
        Lines{"3:10 the crystal is 0 times as long as wide; that must be a number from 0.0001 to 10000"});
  CHECK(wrongPopulation("shape = 'pyramid'\naspect = 1e-12\nupper = 0\nlower = 0") ==
        Lines{"3:10 the crystal is 1e-12 times as long as wide; that must be a number from 0.0001 to 10000"});
  CHECK(wrongPopulation("shape = 'pyramid'\naspect = 0\nupper = 1e-9\nlower = 0").size() == 1);
  CHECK(wrongPopulation("shape = 'pyramid'\nslope = 1e-3") ==
        Lines{"3:9 the crystal is 24810.8002915 times as long as wide; that must be a number from 0.0001 to 10000"});
  CHECK(wrongPopulation("shape = 'pyramid'\nslope = 1e-300").size() == 1);
  CHECK(wrongPopulation("shape = 'pyramid'\naspect = 1e4").size() == 1);
  CHECK(wrongPopulation("aspect = 0").size() == 1);
}

TEST_CASE("tilt and roll need an orientation that has a rest") {
  CHECK(wrongPopulation("tilt = 1") == Lines{"2:8 'tilt' means nothing with the orientation \"random\""});
  CHECK(wrongPopulation("orientation = { zenith = 3 }\nroll = 1") ==
        Lines{"3:8 'roll' cannot be used with an orientation in full"});
  CHECK(wrongPopulation("orientation = { azimuth = 3 }") ==
        Lines{"2:15 an orientation in full needs 'zenith', the c axis' zenith angle"});
  CHECK(wrongPopulation("orientation = { zenith = 200 }").size() == 1);
  CHECK(wrongPopulation("orientation = { zenith = { normal = [-5, 1] } }") ==
        Lines{"2:38 'mean' must be a number from 0 to 180, not -5"});
  CHECK(wrongPopulation("orientation = { zenith = { uniform = [-200, 10] } }") ==
        Lines{"2:39 'from' must be a number from -180 to 360, not -200"});
}

TEST_CASE("populations are a list of at least one, with different names and some weight") {
  CHECK(linesOf(errorsOf("")) == Lines{"0:0 a scene needs at least one population"});
  CHECK(linesOf(errorsOf("population = []")) == Lines{"1:14 a scene needs at least one population"});
  CHECK(linesOf(errorsOf("[population]\nname = 'a'")) ==
        Lines{"1:1 'population' must be a list of tables, not a table"});
  CHECK(errorsOf("[population]").at(0).hint.find("[[population]]") != std::string::npos);
  CHECK(linesOf(errorsOf("population = [1]")) == Lines{"1:15 'population' must be a list of tables, not 1"});
  CHECK(wrongPopulation("name = 'a'\n[[population]]\nname = 'a'") ==
        Lines{"4:8 the name of this population is taken: \"a\""});
  CHECK(wrongPopulation("name = 'population 2'\n[[population]]") ==
        Lines{"3:1 the name of this population is taken: \"population 2\""});
  CHECK(wrongPopulation("weight = 0\n[[population]]\nweight = 0").size() == 1);
  CHECK(wrongPopulation("weight = 0\n[[population]]").empty());
  CHECK(wrongPopulation("name = ''").size() == 1);
  CHECK(wrongPopulation("name = \"a\\u0007\"").size() == 1);
}

TEST_CASE("fields of view stay within what the projection can show") {
  CHECK(wrong("[camera]\nfov_horizontal = 90\nfov_vertical = 60") ==
        Lines{"3:16 the field of view is given twice, by 'fov_horizontal' and by 'fov_vertical'"});
  CHECK(wrong("[camera]\nprojection = 'rectilinear'\nfov_diagonal = 180") ==
        Lines{"3:16 'fov_diagonal' of a projection \"rectilinear\" must be above 0 and below 180 degrees, not 180"});
  CHECK(wrong("[camera]\nprojection = 'fisheye-orthographic'\nfov_vertical = 181").size() == 1);
  CHECK(wrong("[camera]\nprojection = 'fisheye-orthographic'\nfov_vertical = 180").empty());
  CHECK(wrong("[camera]\nprojection = 'fisheye-stereographic'\nfov_vertical = 360").size() == 1);
  CHECK(wrong("[camera]\nprojection = 'fisheye-equidistant'\nfov_vertical = 360").empty());
  CHECK(wrong("[camera]\nprojection = 'equirectangular'\nfov_vertical = 181").size() == 1);
  CHECK(wrong("[camera]\nprojection = 'equirectangular'\nfov_diagonal = 30") ==
        Lines{"3:16 an equirectangular image has no diagonal field of view"});
  CHECK(wrong("[camera]\nprojection = 'rectilinear'\nimage_circle = 90") ==
        Lines{"3:16 only fisheye lenses have an image circle"});
  CHECK(wrong("[camera]\nfov_horizontal = 0").size() == 1);
}

TEST_CASE("resolutions are two integers, of an image that fits into memory") {
  const Lines expected{"2:14 'resolution' must be [width, height], integers from 1 to 32768 pixels"};
  CHECK(wrong("[camera]\nresolution = [0, 10]") == expected);
  CHECK(wrong("[camera]\nresolution = [10.0, 10]") == expected);
  CHECK(wrong("[camera]\nresolution = [10]") == expected);
  CHECK(wrong("[camera]\nresolution = 10") == expected);
  CHECK(wrong("[camera]\nresolution = [32768, 8192]").empty());
  CHECK(wrong("[camera]\nresolution = [32768, 8193]").size() == 1);
}

TEST_CASE("all errors are told at once, sorted by position, each with its line and a caret") {
  try {
    parseScene("[sun]\nelevatoin = 20\n\tdiameter = 'é'\n[[population]]\nweight = -1\n[trace]\nrays = 0\n",
               "scenes/x.toml");
    FAIL("no error");
  } catch (const SceneError& e) {
    CHECK(std::string(e.what()) == R"(scenes/x.toml:2:1: error: unknown key 'elevatoin' in [sun]
    2 | elevatoin = 20
      | ^~~~~~~~~
      did you mean 'elevation'? accepted: azimuth, date, diameter, elevation, latitude, longitude, refraction, spectrum, visible
scenes/x.toml:3:13: error: 'diameter' must be a number from 0 to 10 degrees, not the string "é"
    3 |  diameter = 'é'
      |             ^~~
scenes/x.toml:5:10: error: 'weight' must be a number from 0 to 1000000000, not -1
    5 | weight = -1
      |          ^~
scenes/x.toml:7:8: error: 'rays' must be a whole number of rays from 1 to 1000000000000000, such as 100000, 2e6, "1.5k" or "10M", not 0
    7 | rays = 0
      |        ^)");
  }
}

TEST_CASE("a syntax error has the same form as any other") {
  const auto errors = errorsOf("[sun]\nelevation = \n");
  REQUIRE(errors.size() == 1);
  CHECK(errors[0].line == 2);
  CHECK(errors[0].column == 13);
  CHECK(errors[0].message.starts_with("not TOML: "));
  CHECK(errors[0].hint.empty());
}

TEST_CASE("text without quotation marks is told to have some, and a file of another kind what a scene is") {
  const auto hintOf = [](const std::string& text, const std::string& name) -> std::string {
    try {
      parseScene(text, name, std::span<const std::string>{});
    } catch (const SceneError& error) {
      return error.diagnostics().at(0).hint;
    }
    return "none was wrong";
  };
  CHECK(hintOf("[cloud]\norders = all\n", "x.toml") == "text stands in quotation marks: \"all\"");
  CHECK(hintOf("sun = { spectrum = sun-am1.5, elevation = 3 }\n", "x.toml") ==
        "text stands in quotation marks: \"sun-am1.5\"");
  CHECK(hintOf("elevation 20\n", "x.toml").empty());
  const std::string isTable =
      "a scene is a TOML file; where this is a mesh or a table for one, a key of the scene names it";
  CHECK(hintOf("a,b\n1,2\n", "x.csv") == isTable);
  CHECK(hintOf("v 0 \xC2\xB0 1\n", "sheath.obj") == isTable);
}

TEST_CASE("a file that does not exist is a scene error, one that cannot be read is not") {
  CHECK_THROWS_AS(loadScene("no/such/scene.toml"), SceneError);
  const auto directory = std::filesystem::temp_directory_path();
  try {
    loadScene(directory);
    FAIL("no error");
  } catch (const std::runtime_error& e) {
    CHECK(std::string(e.what()).starts_with(directory.string() + ": "));
  }
}

TEST_CASE("a scene file is read with the name it was given") {
  const auto path = std::filesystem::temp_directory_path() / "parhelion_scene_errors_test.toml";
  std::ofstream(path) << kExample;
  CHECK(loadScene(path).text == kExample);
  std::ofstream(path) << "[sun]\nelevation = 100\n";
  try {
    loadScene(path);
    FAIL("no error");
  } catch (const SceneError& e) {
    CHECK(e.diagnostics().size() == 2);
    CHECK(e.diagnostics().at(0).file == path.string());
  }
  std::filesystem::remove(path);
}
