// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/date_time.h"

namespace parhelion {

// Where the sun stands. Solar position algorithm of Reda & Andreas 2004 (Solar Energy 76, 577, and 81, 838; report
// NREL/TP-560-34302), within 0.0003 degrees from the year -2000 to 6000, and
// the difference of dynamical and universal time after Espenak & Meeus 2006. UTC is taken for universal time: the
// earth's rotation and a clock differ by up to 0.9 seconds, which are 0.004 degrees.

/// Years that a date of the sun may have. Before, clocks and calendars are too uncertain.
inline constexpr int kFirstYear = 500, kLastYear = 3000;

/// A place at sea level.
struct PlaceOnEarth {
  double latitude = 0.0;   // rad, geodetic, north positive, [-pi/2, pi/2]
  double longitude = 0.0;  // rad, east positive
};

/// The sun seen from the earth's centre, as it appears: with aberration, and in the equator and equinox of the moment.
struct GeocentricSun {
  double longitude;       // rad, [0, 2 pi), along the ecliptic
  double rightAscension;  // rad, [0, 2 pi)
  double declination;     // rad
  double distance;        // astronomical units
};

struct SunPosition {
  double elevation;  // rad, above the horizon
  double azimuth;    // rad, [0, 2 pi), from north, clockwise as seen on a map
};

/// Days from noon of 1 January 4713 BC (Julian calendar), universal time.
double julianDay(const DateTime& time);

/// Dynamical minus universal time, s. Polynomials of Espenak & Meeus 2006 (Five Millennium Canon of Solar Eclipses,
/// NASA/TP-2006-214141) for kFirstYear to kLastYear.
double deltaT(double julianDay);

/// `julianEphemerisDay` is in dynamical time: julianDay + deltaT / 86400.
GeocentricSun geocentricSun(double julianEphemerisDay);

/// The sun's centre from a place, without air. `julianDay` is in universal time, `deltaT` in seconds.
SunPosition sunFrom(const PlaceOnEarth& place, double julianDay, double deltaT);
SunPosition sunFrom(const PlaceOnEarth& place, const DateTime& time);

/// By how much the air lifts what stands at `elevation` without it, rad; for an observer at sea level, at 1010 hPa and
/// 10 degrees Celsius. Saemundsson 1986 (Sky & Telescope 72, 70), within 0.1' of Bennett's formula. Where the sun has
/// set, whose light reaches only clouds, it falls off as 1 / tan(elevation), as in NOAA's solar calculator.
double refractionOfAir(double elevation);

}  // namespace parhelion
