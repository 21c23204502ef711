// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include "scene/describe.h"
#include "scene_support.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

std::vector<std::string> wrong(const std::string& override) { return linesOf(errorsOf(kExample, {override})); }

double tiltOf(const PopulationSettings& p) {
  return std::get<Normal>(std::get<AxisOrientation>(p.orientation).zenith).sigma;
}

}  // namespace

TEST_CASE("overrides replace values, add keys and add tables") {
  CHECK(sceneOf(kExample, {"sun.elevation=25"}).sun.elevation == radians(25.0));
  CHECK(sceneOf(kExample, {"camera.image_circle = 190"}).camera.imageCircle == radians(190.0));
  CHECK(std::get<ConstantIndex>(sceneOf(kPopulation, {"ice.index=1.31"}).ice.index).index == 1.31);
  CHECK(sceneOf(kExample, {"camera.resolution=[64, 32]"}).camera.width == 64);
  CHECK(sceneOf(kExample, {"camera.resolution.1=32"}).camera.height == 32);
  CHECK(sceneOf(kExample, {"sun={elevation=3}"}).sun.elevation == radians(3.0));
}

TEST_CASE("populations are picked by index and by name") {
  CHECK(tiltOf(sceneOf(kExample, {"population.0.tilt=2"}).populations[0]) == radians(2.0));
  CHECK(tiltOf(sceneOf(kExample, {"population.plates.tilt=3"}).populations[0]) == radians(3.0));
  const Scene inner = sceneOf(kExample, {"population.free.orientation.zenith=45"});
  CHECK(std::get<FixedValue>(std::get<AxisOrientation>(inner.populations[1].orientation).zenith).value ==
        radians(45.0));
}

TEST_CASE("a value that is not TOML is a bare string") {
  CHECK(sceneOf(kExample, {"trace.engine=embree-robust"}).trace.engine == Engine::embreeRobust);
  CHECK(sceneOf(kExample, {"trace.engine=planes"}).trace.engine == Engine::planes);
  CHECK(sceneOf(kExample, {"trace.engine='auto'"}).trace.engine == Engine::automatic);
  CHECK(sceneOf(kExample, {"trace.engine=\"embree-robust\""}).trace.engine == Engine::embreeRobust);
  CHECK(sceneOf(kExample, {"trace.rays=1.5k"}).trace.rays == 1500);
  CHECK(sceneOf(kExample, {"population.0.name=säulen \"x\" \\"}).populations[0].name == "säulen \"x\" \\");
}

TEST_CASE("overrides apply in order and before validation") {
  CHECK(sceneOf(kExample, {"sun.elevation=25", "sun.elevation=26"}).sun.elevation == radians(26.0));
  CHECK(sceneOf("[sun]\nelevation = 200\n[[population]]", {"sun.elevation=5"}).sun.elevation == radians(5.0));
}

TEST_CASE("an override without a value takes the key out, so that its default counts") {
  CHECK(sceneOf("[sun]\nelevation = 20\ndiameter = 0\n[[population]]", {"sun.diameter="}).sun.diameter ==
        SunSettings{}.diameter);
  const Scene globe = sceneOf("[camera]\nfov_horizontal = 90\n[sun]\nelevation = 20\n[[population]]",
                              {"camera.projection=globe", "camera.fov_horizontal = "});
  CHECK(globe.camera.projection == Projection::globe);
  const auto errors = errorsOf("[sun]\nelevation = 20\n[[population]]", {"sun.elevatio="});
  REQUIRE(errors.size() == 1);
  CHECK(errors[0].message == "the scene has no 'elevatio' to take out");
  CHECK(errors[0].hint == "did you mean 'elevation'?");
  CHECK(errorsOf("[sun]\nelevation = 20\n[[population]]", {"population.0="}).size() == 1);
}

TEST_CASE("an error in an override points into the override") {
  const auto errors = errorsOf(kExample, {"trace.seed=2", "sun.elevation = 250"});
  REQUIRE(errors.size() == 1);
  CHECK(errors[0].file == "-D sun.elevation = 250");
  CHECK(errors[0].line == 1);
  CHECK(errors[0].column == 17);
  CHECK(errors[0].excerpt == "    1 | sun.elevation = 250\n      |                 ^~~\n");
}

TEST_CASE("an error in an option that stands for a key is told in the words of who typed it") {
  struct Case {
    SceneOverride override;
    const char *file, *message;
    int column;
    const char* excerpt;
  };
  for (const auto& [override, file, message, column, excerpt] : std::vector<Case>{
           {overrideOf("--paths", "3-x", "trace.filter"), "--paths '3-x'",
            "'x' is neither a kind of face nor the name of a halo", 3, "    1 | 3-x\n      |   ^\n"},
           // The quote is written for TOML as it need not be on the command line.
           {overrideOf("--paths", "greenler's arc", "trace.filter"), "--paths 'greenler's arc'",
            "'greenler's arc' is neither a kind of face nor the name of a halo", 1,
            "    1 | greenler's arc\n      | ^~~~~~~~~~~~~~\n"},
           {overrideOf("--symmetry", "radial", "trace.symmetry"), "--symmetry 'radial'",
            "the population 'plates' is not in random orientation", 1, "    1 | radial\n      | ^~~~~~\n"},
           {overrideOf("--rays", "0k", "trace.rays", "0"), "--rays '0k'", nullptr, 1, "    1 | 0k\n      | ^\n"},
           {overrideOf("--resolution", "64x0", "camera.resolution", "[64,0]"), "--resolution '64x0'", nullptr, 1,
            "    1 | 64x0\n      | ^~~~\n"},
           {overrideOf("--method", "non", "recon", "{method='non'}"), "--method 'non'", nullptr, 1,
            "    1 | non\n      | ^~~\n"},
           {overrideOf("--no-ground", "", "camera.horizon", "'cit'"), "--no-ground", nullptr, 0, ""}}) {
    CAPTURE(override.text);
    const auto errors = errorsWith(kExample, {override});
    REQUIRE(errors.size() == 1);
    CHECK(errors[0].file == file);
    if (message) CHECK(errors[0].message == message);
    const std::string key = override.text.substr(override.text.find('.') + 1);
    CHECK(errors[0].message.find('\'' + key.substr(0, key.find('=')) + "':") == std::string::npos);
    CHECK(errors[0].line == (column > 0 ? 1 : 0));
    CHECK(errors[0].column == column);
    CHECK(errors[0].excerpt == excerpt);
  }
}

TEST_CASE("unknown keys and elements of overrides are told with what is there") {
  CHECK(wrong("sun.elevatoin=2") == std::vector<std::string>{"1:5 unknown key 'elevatoin' in [sun]"});
  CHECK(errorsOf(kExample, {"sun.elevatoin=2"}).at(0).hint.starts_with("did you mean 'elevation'?"));
  CHECK(wrong("snu.elevation=2") == std::vector<std::string>{"1:1 unknown key 'snu'"});
  CHECK(wrong("population.plate.tilt=2") == std::vector<std::string>{"1:12 no element 'plate' in this list"});
  CHECK(errorsOf(kExample, {"population.plate.tilt=2"}).at(0).hint ==
        "did you mean 'plates'? accepted: an index from 0 to 1, plates, free");
  CHECK(wrong("population.2.tilt=2").size() == 1);
  CHECK(wrong("population.-1.tilt=2").size() == 1);
}

TEST_CASE("overrides that are none are refused") {
  CHECK(wrong("sun") == std::vector<std::string>{"1:1 an override is key.path=value"});
  CHECK(wrong("") == std::vector<std::string>{"1:1 an override is key.path=value"});
  CHECK(wrong("=2").size() == 1);
  CHECK(wrong("sun.=2") == std::vector<std::string>{"1:5 a key is missing here; an override is key.path=value"});
  CHECK(wrong("trace.rays.x=3") == std::vector<std::string>{"1:12 there is no 'x' here: the scene has a plain value"});
  CHECK(wrong("a.b.c.d.e.f=3") == std::vector<std::string>{"1:1 no key of a scene lies so deep"});
  CHECK(wrong("trace.engine=a\nb").size() == 1);
  CHECK(wrong("trace.engine=\xff").size() == 1);
  CHECK(wrong("sun.elevation=" + std::string(100'000, '[')).size() == 1);
}

TEST_CASE("the text of a scene is the user's own, or gives the same scene without the overrides") {
  CHECK(parseScene(kExample, "x.toml").text == kExample);

  const std::vector<std::string> overrides{"sun.elevation=25.1",
                                           "population.plates.tilt={ laplace = 0.3 }",
                                           "population.free.name=\"ü\\\"",
                                           "sun.spectrum=[450, 550.25]",
                                           "sun.spectrum=D65",
                                           "sun.spectrum={wavelengths=[450,550],weights=[1,2]}",
                                           "sun.spectrum={blackbody=3000}",
                                           "trace.rays=3G",
                                           "trace.seed=9223372036854775807"};
  const LoadedScene first = parseScene(kExample, "x.toml", overrides);
  const LoadedScene second = parseScene(first.text, "x.toml");
  CHECK(second.scene.sun.elevation == radians(25.1));
  CHECK(second.scene.trace.rays == 3'000'000'000);
  CHECK(second.scene.trace.seed == 9223372036854775807u);
  CHECK(second.scene.populations[1].name == "\"ü\\\"");
  CHECK(describeScene(second.scene) == describeScene(first.scene));
  CHECK(describeScene(second.scene) != describeScene(sceneOf(kExample)));
}
