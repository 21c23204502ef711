// SPDX-License-Identifier: Apache-2.0
#include "optics/solar_position.h"

#include <doctest/doctest.h>

#include <cmath>
#include <initializer_list>

#include "math/conventions.h"

using namespace parhelion;

namespace {

/// Days from noon of 1 January 4713 BC, of a time in any scale.
double dayOf(int year, int month, int day, int hour, int minute, double second) {
  return julianDay({year, month, day, hour, minute, second, 0});
}

double fromDegrees(double whole, double minutes, double seconds) {
  return radians(whole + minutes / 60.0 + seconds / 3600.0);
}

double angleApart(double a, double b) { return std::abs(std::remainder(a - b, 2.0 * kPi)); }

/// Whether two angles are within so many degrees.
bool near(double angle, double expected, double most) { return degrees(angleApart(angle, expected)) <= most; }

// Golden, Colorado, as in the report's example.
const PlaceOnEarth kGolden{radians(39.742476), radians(-105.1786)};
constexpr double kDeltaTOfExample = 67.0;

/// Elevation at a date without air, degrees.
double bareElevation(const PlaceOnEarth& place, const DateTime& time) {
  return degrees(sunFrom(place, time).elevation);
}

}  // namespace

TEST_CASE("the sun stands where the worked example of Reda and Andreas 2004 has it, digit by digit") {
  const DateTime time{2003, 10, 17, 12, 30, 30.0, -7 * 60};
  const double day = julianDay(time);
  CHECK(day == doctest::Approx(2452930.312847).epsilon(1e-13));
  const GeocentricSun sun = geocentricSun(day + kDeltaTOfExample / 86400.0);
  CHECK(sun.distance == doctest::Approx(0.9965422974).epsilon(1e-10));
  CHECK(near(sun.longitude, radians(204.0085519281), 1e-8));
  CHECK(near(sun.rightAscension, radians(202.22741), 5e-6));
  CHECK(near(sun.declination, radians(-9.31434), 5e-6));

  const SunPosition seen = sunFrom(kGolden, day, kDeltaTOfExample);
  // Zenith angle 50.11162 through air of 820 hPa and 11 degrees, which lifts by this much; the observer's 1830 m change
  // the parallax by 7e-7 degrees.
  const double lift = 820.0 / 1010.0 * 283.0 / 284.0 * degrees(refractionOfAir(seen.elevation));
  CHECK(90.0 - degrees(seen.elevation) - lift == doctest::Approx(50.11162).epsilon(3e-7));
  CHECK(near(seen.azimuth, radians(194.34024), 1e-5));
}

TEST_CASE("the worked example's sun rises, crosses the meridian and sets at the published times of that day of UTC") {
  // To the second, in which the sun climbs 0.003 degrees; the interpolation there is good for two.
  constexpr double kLimb = -0.8333;  // of the centre, when the upper limb is on the horizon
  CHECK(std::abs(bareElevation(kGolden, {2003, 10, 17, 13, 12, 43.46, 0}) - kLimb) < 0.004);
  CHECK(std::abs(bareElevation(kGolden, {2003, 10, 17, 0, 20, 19.19, 0}) - kLimb) < 0.004);
  CHECK(near(sunFrom(kGolden, DateTime{2003, 10, 17, 18, 46, 4.97, 0}).azimuth, kPi, 0.005));
}

TEST_CASE("the sun is where Meeus computes it with all of VSOP87 on 1992 October 13 at 0h dynamical time") {
  // Astronomical Algorithms, 2nd edition, example 25.b and the values that follow it.
  const GeocentricSun sun = geocentricSun(dayOf(1992, 10, 13, 0, 0, 0.0));
  CHECK(near(sun.longitude, fromDegrees(199, 54, 21.818), 3e-4));
  CHECK(near(sun.rightAscension, 15.0 * fromDegrees(13, 13, 30.749), 3e-4));
  CHECK(near(sun.declination, -fromDegrees(7, 47, 1.74), 3e-4));
  CHECK(sun.distance == doctest::Approx(0.99760853).epsilon(1e-6));
}

TEST_CASE("the sun's longitude is a multiple of 90 degrees at the equinoxes and solstices of 1996 to 2005") {
  // Astronomical Algorithms, 2nd edition, table 27.E: instants by all of VSOP87, dynamical time. A second is 1.1e-5
  // degrees of longitude; the algorithm promises 3e-4.
  struct Instant {
    int year, day, hour, minute, second;
  };
  const struct {
    int month;
    double longitude;
    std::initializer_list<Instant> instants;
  } seasons[] = {{3,
                  0.0,
                  {{1996, 20, 8, 4, 7},
                   {1997, 20, 13, 55, 42},
                   {1998, 20, 19, 55, 35},
                   {1999, 21, 1, 46, 53},
                   {2000, 20, 7, 36, 19},
                   {2001, 20, 13, 31, 47},
                   {2002, 20, 19, 17, 13},
                   {2003, 21, 1, 0, 50},
                   {2004, 20, 6, 49, 42},
                   {2005, 20, 12, 34, 29}}},
                 {6,
                  90.0,
                  {{1996, 21, 2, 24, 46},
                   {1997, 21, 8, 20, 59},
                   {1998, 21, 14, 3, 38},
                   {1999, 21, 19, 50, 11},
                   {2000, 21, 1, 48, 46},
                   {2001, 21, 7, 38, 48},
                   {2002, 21, 13, 25, 29},
                   {2003, 21, 19, 11, 32},
                   {2004, 21, 0, 57, 57},
                   {2005, 21, 6, 47, 12}}},
                 {9,
                  180.0,
                  {{1996, 22, 18, 1, 8},
                   {1997, 22, 23, 56, 49},
                   {1998, 23, 5, 38, 15},
                   {1999, 23, 11, 32, 34},
                   {2000, 22, 17, 28, 40},
                   {2001, 22, 23, 5, 32},
                   {2002, 23, 4, 56, 28},
                   {2003, 23, 10, 47, 53},
                   {2004, 22, 16, 30, 54},
                   {2005, 22, 22, 24, 14}}},
                 {12,
                  270.0,
                  {{1996, 21, 14, 6, 56},
                   {1997, 21, 20, 8, 5},
                   {1998, 22, 1, 57, 31},
                   {1999, 22, 7, 44, 52},
                   {2000, 21, 13, 38, 30},
                   {2001, 21, 19, 22, 34},
                   {2002, 22, 1, 15, 26},
                   {2003, 22, 7, 4, 53},
                   {2004, 21, 12, 42, 40},
                   {2005, 21, 18, 36, 1}}}};
  for (const auto& [month, longitude, instants] : seasons) {
    for (const auto& [year, day, hour, minute, second] : instants) {
      const GeocentricSun sun = geocentricSun(dayOf(year, month, day, hour, minute, second));
      CHECK_MESSAGE(near(sun.longitude, radians(longitude), 3e-4), year << '-' << month);
    }
  }
}

TEST_CASE("the solstices of 2000 have the declination of the obliquity, and the equinoxes none") {
  // Obliquity of date 23.4393 - 0.0013 degrees a decade, nutation within 0.0026.
  CHECK(degrees(geocentricSun(dayOf(2000, 6, 21, 1, 48, 46.0)).declination) ==
        doctest::Approx(23.4393).epsilon(0.0001));
  CHECK(degrees(geocentricSun(dayOf(2000, 12, 21, 13, 38, 30.0)).declination) ==
        doctest::Approx(-23.4393).epsilon(0.0001));
  CHECK(std::abs(degrees(geocentricSun(dayOf(2000, 3, 20, 7, 36, 19.0)).declination)) < 3e-4);
}

TEST_CASE("dynamical and universal time differ as Espenak and Meeus 2006 tabulate it") {
  // Their table of values from historical records, seconds, for 1 January of the year; the polynomials fit it within 1
  // s from 1700 on.
  const struct {
    int year;
    double seconds, most;
  } values[] = {{1000, 1570, 20},  {1500, 200, 20},   {1600, 120, 20},   {1700, 9, 5},      {1750, 13, 2},
                {1800, 14, 1},     {1850, 7, 1},      {1900, -3, 1},     {1950, 29, 0.5},   {1955, 31.1, 0.5},
                {1970, 40.2, 0.5}, {1980, 50.5, 0.5}, {1990, 56.9, 0.5}, {2000, 63.8, 0.5}, {2005, 64.7, 0.5}};
  for (const auto& [year, seconds, most] : values)
    CHECK_MESSAGE(std::abs(deltaT(dayOf(year, 1, 1, 0, 0, 0.0)) - seconds) <= most, year);
  // No piece of the polynomials leaves a step of more than a second and a half, save that at 1600.
  for (const int year : {1700, 1800, 1860, 1900, 1920, 1941, 1961, 1986, 2005, 2050, 2150}) {
    const double border = dayOf(year, 1, 1, 0, 0, 0.0);
    CHECK_MESSAGE(std::abs(deltaT(border + 2.0) - deltaT(border - 2.0)) < 1.5, year);
  }
}

TEST_CASE(
    "at local noon the sun is in the south from the north, in the north from the south, and east in the morning") {
  const double noon = dayOf(2026, 3, 21, 12, 7, 0.0);  // the equation of time is -7 min
  CHECK(near(sunFrom({radians(50.0), 0.0}, noon, 69.0).azimuth, kPi, 0.2));
  CHECK(near(sunFrom({radians(-50.0), 0.0}, noon, 69.0).azimuth, 0.0, 0.2));
  CHECK(near(sunFrom({radians(50.0), 0.0}, noon - 0.25, 69.0).azimuth, radians(90.0), 1.0));
  CHECK(near(sunFrom({radians(50.0), 0.0}, noon + 0.25, 69.0).azimuth, radians(270.0), 1.0));
  // Ninety degrees further east the sun sets at that moment.
  CHECK(std::abs(degrees(sunFrom({0.0, radians(90.0)}, noon, 69.0).elevation)) < 0.2);
}

TEST_CASE("from the poles the sun has the height of its declination, less its parallax") {
  const double day = dayOf(2026, 6, 21, 8, 0, 0.0);
  const double declination = geocentricSun(day + 69.0 / 86400.0).declination;
  const double parallax = radians(8.794 / 3600.0) * std::cos(declination) / 1.0163;
  CHECK(near(sunFrom({0.5 * kPi, 0.0}, day, 69.0).elevation, declination - parallax, 1e-5));
  CHECK(near(sunFrom({-0.5 * kPi, 0.0}, day, 69.0).elevation, -declination - parallax, 1e-5));
}

TEST_CASE("the air lifts the sun as Bennett's formula has it, and never bends one position onto another") {
  // Bennett 1982: minutes of arc by the elevation that is seen.
  const auto bennett = [](double seen) { return 1.0 / std::tan(radians(seen + 7.31 / (seen + 4.4))); };
  for (const double bare : {-0.57, 0.0, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 45.0, 80.0}) {
    const double lift = degrees(refractionOfAir(radians(bare)));
    CHECK_MESSAGE(std::abs(60.0 * lift - bennett(bare + lift)) < 0.1, bare);
  }
  CHECK(60.0 * degrees(refractionOfAir(radians(-0.575))) == doctest::Approx(34.5).epsilon(0.005));
  double below = -90.0 + degrees(refractionOfAir(radians(-90.0)));
  for (int i = -8999; i <= 9000; ++i) {
    const double seen = 0.01 * i + degrees(refractionOfAir(radians(0.01 * i)));
    CHECK(seen > below);
    CHECK(seen < below + 0.02);  // no step, at the horizon neither
    below = seen;
  }
}
