// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_halos.h"

#include <string>

#include <doctest/doctest.h>

#include "scene/parse_scene.h"

using namespace parhelion;

namespace {

SceneHalos halosOfPopulation(const std::string& keys) {
  return halosOf(parseScene("[[population]]\nname = \"p\"\n" + keys, "test").scene.populations);
}

/// The family of a population; empty if its halos have no name.
std::string familyOf(const std::string& keys) {
  const SceneHalos halos = halosOfPopulation(keys);
  CHECK(halos.makers.size() + halos.nameless.size() == 1);
  return halos.makers.empty() ? "" : std::string(nameOf(halos.makers[0].family));
}

}  // namespace

TEST_CASE("crystals belong to the family of the way they really stand, not of their words") {
  const std::pair<const char*, const char*> cases[] = {
      {"orientation = \"plate\"\ntilt = 1", "plates"},
      {"orientation = \"plate\"\ntilt = 9", "plates"},
      {"orientation = \"plate\"\ntilt = 12", "random"},  // two thirds of a normal tilt are within 1.48 sigma
      {"orientation = \"plate\"\ntilt = 40", "random"},
      {"orientation = \"plate\"\ntilt = { uniform = 20 }", "plates"},  // two thirds are within 13.3 degrees
      {"orientation = \"column\"\ntilt = 0.5", "columns"},
      {"orientation = \"column\"\ntilt = 14", "columns"},
      {"orientation = \"column\"\ntilt = 30", "random"},
      {"orientation = \"column\"\nroll = 5", "parry"},
      {"orientation = \"parry\"\ntilt = 1\nroll = 1", "parry"},
      {"orientation = \"parry\"\ntilt = 1\nroll = 25", "columns"},
      {"orientation = \"parry\"\ntilt = 40", "lowitz"},  // which also turn about a level axis from edge to edge
      {"orientation = \"lowitz\"\ntilt = 1", "lowitz"},
      {"orientation = \"lowitz\"\ntilt = 1\nroll = 2", "plates"},
      {"orientation = \"lowitz\"\ntilt = 1\nroll = 40", "lowitz"},
      {"orientation = \"random\"", "random"},
      {"orientation = { zenith = 180 }", "plates"},
      {"orientation = { zenith = 90 }", "columns"},
      {"orientation = { zenith = 90, roll = 60 }", "parry"},
      {"orientation = { zenith = { normal = [0, 3] } }", "plates"},
      {"orientation = { zenith = 45 }", ""},
  };
  for (const auto& [keys, family] : cases) CHECK_MESSAGE(familyOf(keys) == family, keys);
}

TEST_CASE("the faces of a population's halos are those of its crystals") {
  CHECK(halosOfPopulation("aspect = 2").makers[0].faces.size() == 8);
  const HaloMaker cut = halosOfPopulation("shape = \"pyramid\"\naspect = 0\nupper = 1\nlower = 0.5").makers[0];
  CHECK(cut.faces.size() == 13);
  CHECK(!cut.hasSides());
  CHECK(cut.hasEnds());
  // A bullet has an end, six sides and a pyramid.
  CHECK(halosOfPopulation("shape = \"rosette\"").makers[0].faces.size() == 13);
}

TEST_CASE("populations without weight make no halos, and those without a name for theirs are told") {
  const std::string two = "orientation = \"plate\"\nweight = 0\n[[population]]\nname = \"q\"\norientation = \"column\"";
  const SceneHalos halos = halosOfPopulation(two);
  REQUIRE(halos.makers.size() == 1);
  CHECK(halos.makers[0].family == HaloFamily::columns);
  CHECK(halosOfPopulation("orientation = { zenith = 45 }").nameless == std::vector<std::string>{"p"});
}
