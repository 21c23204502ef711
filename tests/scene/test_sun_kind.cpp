// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "optics/solar_position.h"
#include "scene/describe.h"
#include "scene_support.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

using Lines = std::vector<std::string>;

// Near Garmisch-Partenkirchen, on a winter's morning.
const std::string kPlace = "latitude = 47.42\nlongitude = 10.98\n";
const std::string kDated = "[sun]\ndate = 2026-12-21T09:30:00+01:00\n" + kPlace;

Lines wrong(const std::string& text) { return linesOf(errorsOf(text + "\n[[population]]")); }

/// The azimuth of a camera from the sun, degrees.
double azimuthOf(const std::string& tables) { return degrees(sceneWith(tables).camera.azimuth); }

}  // namespace

TEST_CASE("a date and a place put the sun where it stood, lifted by the air, to 0.0001 degrees") {
  const DateTime date{2026, 12, 21, 8, 30, 0.0, 0};
  const SunPosition sun = sunFrom({radians(47.42), radians(10.98)}, date);
  const Scene scene = sceneWith(kDated);
  CHECK(std::abs(degrees(scene.sun.elevation - sun.elevation - refractionOfAir(sun.elevation))) < 0.500001e-4);
  REQUIRE(scene.sun.azimuth);
  CHECK(std::abs(degrees(*scene.sun.azimuth - sun.azimuth)) < 0.500001e-4);
  CHECK(sceneWith(kDated + "refraction = true").sun.elevation == scene.sun.elevation);
  CHECK(std::abs(degrees(sceneWith(kDated + "refraction = false").sun.elevation - sun.elevation)) < 0.500001e-4);
  // The same moment by another clock.
  CHECK(sceneWith("[sun]\ndate = 2026-12-21 04:00:00-04:30\n" + kPlace).sun.elevation == scene.sun.elevation);
}

TEST_CASE("the elevation that a scene tells is the very one it has, so it can be written in the place of the date") {
  const Scene scene = sceneWith(kDated);
  const std::string told = describeScene(scene);
  const std::string number = told.substr(told.find("elevation ") + 10, told.find("°") - told.find("elevation ") - 10);
  CHECK(sceneWith("sun.elevation = " + number).sun.elevation == scene.sun.elevation);
  CHECK(told.find("° from north, diameter") != std::string::npos);
}

TEST_CASE("a sun that has set by its date is as good as one by its elevation") {
  CHECK(sceneWith("[sun]\ndate = 2026-12-21T23:30:00+01:00\n" + kPlace).sun.elevation < radians(-60.0));
}

TEST_CASE("an azimuth from north is one from the sun, less the sun's own, within half a turn") {
  CHECK(azimuthOf("[sun]\nazimuth = 100\n[camera]\nazimuth = 135\nazimuth_from = 'north'") == doctest::Approx(35.0));
  CHECK(azimuthOf("[sun]\nazimuth = 300\n[camera]\nazimuth = 10\nazimuth_from = 'north'") == doctest::Approx(70.0));
  CHECK(azimuthOf("[sun]\nazimuth = 100\n[camera]\nazimuth_from = 'north'") == doctest::Approx(-100.0));
  CHECK(azimuthOf("[sun]\nazimuth = 100\n[camera]\nazimuth = 135\nazimuth_from = 'sun'") == doctest::Approx(135.0));
  const double sun = degrees(*sceneWith(kDated).sun.azimuth);
  CHECK(azimuthOf(kDated + "[camera]\nazimuth = 135\nazimuth_from = 'north'") == doctest::Approx(135.0 - sun));
}

TEST_CASE("what is wrong with a date, its place or north is said once, where it is") {
  const std::string form = "a date and time with its offset from UTC, such as 2026-12-21T09:30:00+01:00";
  const auto dated = [](const std::string& date) { return wrong("[sun]\ndate = " + date + "\n" + kPlace); };
  CHECK(dated("2026-02-30T09:30:00Z") ==
        Lines{"2:18 not TOML: Error while parsing date: expected day between 1 and 28 (inclusive), saw 30"});
  CHECK(dated("2026-12-21T09:30:00") == Lines{"2:8 'date' says no offset from UTC: it must be " + form});
  CHECK(dated("2026-12-21") == Lines{"2:8 'date' must be " + form + ", not a date alone"});
  CHECK(dated("'2026-12-21T09:30:00Z'") ==
        Lines{"2:8 'date' must be " + form + ", not the string \"2026-12-21T09:30:00Z\""});
  CHECK(dated("0499-12-21T09:30:00Z") == Lines{"2:8 'date' must be in a year from 500 to 3000, not 499"});
  CHECK(dated("3001-12-21T09:30:00Z") == Lines{"2:8 'date' must be in a year from 500 to 3000, not 3001"});
  CHECK(wrong("[sun]\ndate = 2026-12-21T09:30:00Z\nlatitude = 5") ==
        Lines{"2:8 a 'date' tells where the sun stands only with a place: 'longitude' is missing"});
  CHECK(wrong("[sun]\ndate = 2026-12-21T09:30:00Z") ==
        Lines{"2:8 a 'date' tells where the sun stands only with a place: 'latitude' is missing"});
  CHECK(wrong(kDated + "elevation = 20") ==
        Lines{"5:13 the sun's elevation is given twice, by 'elevation' and by 'date'"});
  CHECK(wrong(kDated + "azimuth = 20") == Lines{"5:11 the sun's azimuth is given twice, by 'azimuth' and by 'date'"});
  CHECK(wrong("[sun]\n" + kPlace) == Lines{"2:12 'latitude' is of use only with a 'date'"});
  CHECK(wrong("[sun]\nrefraction = false") == Lines{"2:14 'refraction' is of use only with a 'date'"});
  CHECK(wrong("[sun]\ndate = 2026-12-21T09:30:00Z\nlatitude = 90.5\nlongitude = 5") ==
        Lines{"3:12 'latitude' must be a number from -90 to 90 degrees, not 90.5"});
  CHECK(wrong("[sun]\ndate = 2026-12-21T09:30:00Z\nlatitude = 9\nlongitude = -181") ==
        Lines{"4:13 'longitude' must be a number from -180 to 180 degrees, not -181"});
  CHECK(wrong("[camera]\nazimuth_from = 'north'") ==
        Lines{"2:16 where north is depends on the sun, whose azimuth is not known"});
  CHECK(wrong("[camera]\nazimuth_from = 'north'\n[sun]\ndate = 2026-12-21") ==
        Lines{"4:8 'date' must be " + form + ", not a date alone",
              "4:8 a 'date' tells where the sun stands only with a place: 'latitude' is missing"});
}

TEST_CASE("of an elevation and a date on the command line the later one places the sun") {
  const std::string elevated = "[sun]\nelevation = 33\nazimuth = 10\n[[population]]";
  const std::vector<std::string> date{"sun.date=2026-12-21T09:30:00+01:00", "sun.latitude=47.42",
                                      "sun.longitude=10.98"};
  CHECK(sceneOf(elevated, date).sun.elevation == sceneWith(kDated).sun.elevation);
  CHECK(sceneOf(elevated, date).sun.azimuth == sceneWith(kDated).sun.azimuth);
  std::vector<std::string> both = date;
  both.emplace_back("sun.elevation=5");
  CHECK(sceneOf(elevated, both).sun.elevation == radians(5.0));
  CHECK(sceneOf(kDated + "refraction = false\n[[population]]", {"sun.elevation=5"}).sun.elevation == radians(5.0));
  CHECK(linesOf(errorsOf(kDated + "[[population]]", {"sun.date=2026-02-30T09:30:00Z"})).size() == 1);
}

TEST_CASE("a scene with a date on the command line is written out with it, and reads back as the same") {
  const std::string text = parseScene("[[population]]", "x.toml",
                                      std::vector<std::string>{"sun.date=2026-12-21T09:30:00.5+01:00",
                                                               "sun.latitude=47.42", "sun.longitude=10.98"})
                               .text;
  CHECK(text.find("2026-12-21T09:30:00.5+01:00") != std::string::npos);
  CHECK(sceneOf(text).sun.elevation != sceneWith(kDated).sun.elevation);
}
