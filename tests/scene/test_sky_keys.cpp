// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "scene/describe.h"
#include "scene/traced_keys.h"
#include "scene_support.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

std::vector<std::string> linesWith(const std::string& tables) { return linesOf(errorsOf(tables + "\n[[population]]")); }

std::uint64_t hashWith(const std::string& tables) {
  const Scene scene = sceneWith(tables);
  return hashOf(talliedKeys(scene, scene.trace));
}

}  // namespace

TEST_CASE("a scene says its air in numbers, tables and names") {
  const Scene scene = sceneWith(
      "observer = { altitude = 1200 }\n[sky]\nair = true\nozone = 344\nground = 'snow'\n"
      "aerosol = { beta = 0.1, alpha = 1.0, albedo = 0.9, g = 0.6, height = 2000 }");
  CHECK(scene.sky.air);
  CHECK(scene.sky.ozone == 344.0);
  CHECK(scene.sky.aerosol.beta == 0.1);
  CHECK(scene.sky.aerosol.alpha == 1.0);
  CHECK(scene.sky.aerosol.albedo == 0.9);
  CHECK(scene.sky.aerosol.g == 0.6);
  CHECK(scene.sky.aerosol.height == 2000.0);
  CHECK(scene.sky.ground == 0.8);
  CHECK(scene.observer.altitude == 1200.0);
  const Scene shorter = sceneWith("sky = { air = false, aerosol = 0.2, ground = { albedo = 0.3 } }");
  CHECK_FALSE(shorter.sky.air);
  CHECK(shorter.sky.aerosol.beta == 0.2);
  CHECK(shorter.sky.aerosol.alpha == AerosolSettings{}.alpha);
  CHECK(shorter.sky.ground == 0.3);
}

TEST_CASE("air that cannot be is told in one error each") {
  CHECK(linesWith("sky.aerosol = { albedo = 1.2 }\nsky.air = true") ==
        std::vector<std::string>{"1:26 'albedo' must be a number from 0 to 1, not 1.2"});
  CHECK(errorsOf("sky.aerosol = { albedo = -0.1 }\nsky.air = true\n[[population]]").at(0).hint ==
        "an aerosol cannot absorb or scatter more than it extinguishes");
  CHECK(linesWith("sky.aerosol = -0.1\nsky.air = true") ==
        std::vector<std::string>{"1:15 'aerosol' must be a number from 0 to 10 or a table, not -0.1"});
  CHECK(linesWith("sky.aerosol = { beta = -1 }\nsky.air = true") ==
        std::vector<std::string>{"1:24 'beta' must be a number from 0 to 10, not -1"});
  CHECK(linesWith("sky.ozone = -300\nsky.air = true") ==
        std::vector<std::string>{"1:13 'ozone' must be a number from 0 to 1000 Dobson units, not -300"});
  CHECK(linesWith("sky.ground = { albedo = 2 }\nsky.air = true") ==
        std::vector<std::string>{"1:25 'albedo' must be a number from 0 to 1, not 2"});
  CHECK(errorsOf("sky.ground = 'snw'\nsky.air = true\n[[population]]").at(0).hint.find("did you mean 'snow'?") == 0);
  CHECK(linesWith("observer.altitude = -5\nsky.air = true") ==
        std::vector<std::string>{"1:21 'altitude' must be a number from 0 to 50000 m, not -5"});
  CHECK(linesWith("sky.air = true\nsun.spectrum = 'D65'") ==
        std::vector<std::string>{"2:16 with 'sky.air' the sun has a spectrum of its own"});
  CHECK(linesWith("sky.air = true\nsun.spectrum = 'sun'").empty());
}

TEST_CASE("keys of the air and of the observer's altitude are errors where a scene says nothing of air") {
  for (const char* key : {"sky.ozone = 200", "sky.aerosol = 0.1", "sky.ground = 'snow'", "observer.altitude = 3000"}) {
    const std::string said = key, name = said.substr(0, said.find(' '));
    CHECK(linesWith(said).at(0).ends_with(" '" + name + "' changes nothing where there is no air"));
    CHECK(linesWith(said).size() == 1);
    CHECK(linesWith(said + "\nsky.air = false").empty());
    CHECK(linesWith(said + "\nsky.air = true").empty());
  }
  const std::string cloud = "cloud = { optical_depth = 1, altitude = 9000 }";
  CHECK(linesWith(cloud) == std::vector<std::string>{"1:41 'cloud.altitude' changes nothing where there is no air"});
  CHECK(linesWith(cloud + "\nsky.air = true").empty());
  CHECK(linesWith("sky.air = true\ncloud = { optical_depth = 1, altitude = -1 }").at(0).ends_with("not -1"));
}

TEST_CASE("a summary tells the air where there is one") {
  CHECK(describeScene(sceneWith("sky.air = true")).find("\nair         ozone 300 Dobson units; aerosol beta 0.03, ") !=
        std::string::npos);
  CHECK(describeScene(sceneWith("")).find("\nair ") == std::string::npos);
}

TEST_CASE("what reddens the sun decides what becomes of rays, the ground does not") {
  const std::uint64_t none = hashWith(""), air = hashWith("sky.air = true");
  CHECK(hashWith("sky = { air = false, ozone = 500 }") == none);
  CHECK(air != none);
  CHECK(hashWith("sky = { air = true, ground = 'snow' }") == air);
  CHECK(hashWith("sky = { air = true, aerosol = { g = 0.5, albedo = 0.8 } }") == air);
  CHECK(hashWith("sky = { air = true, ozone = 200 }") != air);
  CHECK(hashWith("sky = { air = true, aerosol = 0.2 }") != air);
  CHECK(hashWith("sky.air = true\nobserver.altitude = 2000") != air);
  const std::uint64_t cloud = hashWith("sky.air = true\ncloud = { optical_depth = 1, altitude = 9000 }");
  CHECK(cloud != hashWith("sky.air = true\ncloud.optical_depth = 1"));
  CHECK(cloud == hashWith("sky.air = true\nobserver.altitude = 2000\ncloud = { optical_depth = 1, altitude = 9000 }"));
}
