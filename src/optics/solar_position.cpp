// SPDX-License-Identifier: Apache-2.0
#include "optics/solar_position.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "math/conventions.h"
#include "math/portable.h"
#include "optics/solar_terms.h"

namespace parhelion {

namespace {

constexpr double kJ2000 = 2451545.0;        // Julian day
constexpr double kDaysOfCentury = 36525.0;  // Julian
constexpr double kSecondsOfDay = 86400.0;
constexpr double kUnixEpoch = 2440587.5;  // Julian day
constexpr double kArcSecond = radians(1.0 / 3600.0);

double polynomial(double x, std::span<const double> coefficients) {
  double sum = 0.0;
  for (std::size_t i = coefficients.size(); i-- > 0;) sum = sum * x + coefficients[i];
  return sum;
}

template <std::size_t N>
double polynomial(double x, const double (&coefficients)[N]) {
  return polynomial(x, std::span<const double>(coefficients));
}

/// [0, 2 pi)
double wholeTurn(double angle) {
  const double turn = 2.0 * kPi, rest = angle - turn * std::floor(angle / turn);
  return rest < turn ? rest : 0.0;
}

/// Powers of t times periodic series, 1e-8.
double sumOfSeries(std::span<const std::span<const SeriesTerm>> powers, double t) {
  double sum = 0.0;
  for (std::size_t power = powers.size(); power-- > 0;) {
    double series = 0.0;
    for (const SeriesTerm& term : powers[power]) series += term.amplitude * portable::cos(term.phase + term.rate * t);
    sum = sum * t + series;
  }
  return 1e-8 * sum;
}

struct Nutation {
  double longitude, obliquity;  // rad
};

/// `t` in Julian centuries of dynamical time from J2000. Reda & Andreas 2004, eqs. 15 to 23.
Nutation nutationAt(double t) {
  const double angles[] = {
      polynomial(t, {297.85036, 445267.111480, -0.0019142, 1.0 / 189474.0}),  // mean elongation of the moon, degrees
      polynomial(t, {357.52772, 35999.050340, -0.0001603, -1.0 / 300000.0}),  // mean anomaly of the sun
      polynomial(t, {134.96298, 477198.867398, 0.0086972, 1.0 / 56250.0}),    // of the moon
      polynomial(t, {93.27191, 483202.017538, -0.0036825, 1.0 / 327270.0}),   // the moon's argument of latitude
      polynomial(t, {125.04452, -1934.136261, 0.0020708, 1.0 / 450000.0})};   // longitude of its ascending node
  Nutation sum{0.0, 0.0};
  for (const NutationTerm& term : kNutation) {
    double angle = 0.0;
    for (std::size_t i = 0; i < term.multiples.size(); ++i) angle += term.multiples[i] * angles[i];
    const auto [sine, cosine] = portable::sincos(radians(angle));
    sum.longitude += (term.longitude + term.longitudeRate * t) * sine;
    sum.obliquity += (term.obliquity + term.obliquityRate * t) * cosine;
  }
  return {1e-4 * kArcSecond * sum.longitude, 1e-4 * kArcSecond * sum.obliquity};
}

/// Of the ecliptic to the equator of the moment, rad; `t` as above. Reda & Andreas 2004, eqs. 24 and 25.
double obliquityAt(double t, const Nutation& nutation) {
  const double mean =
      polynomial(0.01 * t, {84381.448, -4680.93, -1.55, 1999.25, -51.38, -249.67, -39.05, 7.12, 27.87, 5.79, 2.45});
  return kArcSecond * mean + nutation.obliquity;
}

double centuriesOf(double julianDay) { return (julianDay - kJ2000) / kDaysOfCentury; }

/// Apparent sidereal time at Greenwich, rad. Reda & Andreas 2004, eqs. 28 and 29.
double siderealTime(double julianDay, double julianEphemerisDay) {
  const double t = centuriesOf(julianDay), ephemeris = centuriesOf(julianEphemerisDay);
  const double mean =
      280.46061837 + 360.98564736629 * (julianDay - kJ2000) + polynomial(t, {0.0, 0.0, 0.000387933, -1.0 / 38710000.0});
  const Nutation nutation = nutationAt(ephemeris);
  return radians(mean) + nutation.longitude * portable::cos(obliquityAt(ephemeris, nutation));
}

}  // namespace

double julianDay(const DateTime& time) { return kUnixEpoch + unixSeconds(time) / kSecondsOfDay; }

double deltaT(double julianDay) {
  const double year = 2000.0 + (julianDay - kJ2000) / 365.2425;
  const double parabola = -20.0 + 32.0 * ((year - 1820.0) / 100.0) * ((year - 1820.0) / 100.0);
  if (year < 1600.0)
    return polynomial((year - 1000.0) / 100.0,
                      {1574.2, -556.01, 71.23472, 0.319781, -0.8503463, -0.005050998, 0.0083572073});
  if (year < 1700.0) return polynomial(year - 1600.0, {120.0, -0.9808, -0.01532, 1.0 / 7129.0});
  if (year < 1800.0) return polynomial(year - 1700.0, {8.83, 0.1603, -0.0059285, 0.00013336, -1.0 / 1174000.0});
  if (year < 1860.0)
    return polynomial(year - 1800.0, {13.72, -0.332447, 0.0068612, 0.0041116, -0.00037436, 0.0000121272, -0.0000001699,
                                      0.000000000875});
  if (year < 1900.0)
    return polynomial(year - 1860.0, {7.62, 0.5737, -0.251754, 0.01680668, -0.0004473624, 1.0 / 233174.0});
  if (year < 1920.0) return polynomial(year - 1900.0, {-2.79, 1.494119, -0.0598939, 0.0061966, -0.000197});
  if (year < 1941.0) return polynomial(year - 1920.0, {21.20, 0.84493, -0.076100, 0.0020936});
  if (year < 1961.0) return polynomial(year - 1950.0, {29.07, 0.407, -1.0 / 233.0, 1.0 / 2547.0});
  if (year < 1986.0) return polynomial(year - 1975.0, {45.45, 1.067, -1.0 / 260.0, -1.0 / 718.0});
  if (year < 2005.0)
    return polynomial(year - 2000.0, {63.86, 0.3345, -0.060374, 0.0017275, 0.000651814, 0.00002373599});
  if (year < 2050.0) return polynomial(year - 2000.0, {62.92, 0.32217, 0.005589});
  return year < 2150.0 ? parabola - 0.5628 * (2150.0 - year) : parabola;
}

GeocentricSun geocentricSun(double julianEphemerisDay) {
  const double t = centuriesOf(julianEphemerisDay), millennia = 0.1 * t;
  const double distance = sumOfSeries(kEarthRadius, millennia);
  const double aberration = -20.4898 * kArcSecond / distance;
  const Nutation nutation = nutationAt(t);

  // The sun is where the earth, seen from the sun, is not.
  const double longitude = sumOfSeries(kEarthLongitude, millennia) + kPi + nutation.longitude + aberration;
  const double latitude = -sumOfSeries(kEarthLatitude, millennia);

  // From the ecliptic to the equator: a turn about the equinox.
  const auto [sinLongitude, cosLongitude] = portable::sincos(longitude);
  const auto [sinLatitude, cosLatitude] = portable::sincos(latitude);
  const auto [sinTurn, cosTurn] = portable::sincos(obliquityAt(t, nutation));
  const double x = cosLatitude * cosLongitude, inEcliptic = cosLatitude * sinLongitude;
  const double y = cosTurn * inEcliptic - sinTurn * sinLatitude, z = sinTurn * inEcliptic + cosTurn * sinLatitude;
  return {wholeTurn(longitude), wholeTurn(portable::atan2(y, x)), portable::atan2(z, std::sqrt(x * x + y * y)),
          distance};
}

SunPosition sunFrom(const PlaceOnEarth& place, double julianDay, double deltaT) {
  const double ephemerisDay = julianDay + deltaT / kSecondsOfDay;
  const GeocentricSun sun = geocentricSun(ephemerisDay);

  // +x in the meridian's plane, +y east of it, +z along the earth's axis; lengths in astronomical units.
  const double hourAngle = siderealTime(julianDay, ephemerisDay) + place.longitude - sun.rightAscension;
  const auto [sinHour, cosHour] = portable::sincos(hourAngle);
  const auto [sinDeclination, cosDeclination] = portable::sincos(sun.declination);
  const auto [sinLatitude, cosLatitude] = portable::sincos(place.latitude);
  double x = sun.distance * cosDeclination * cosHour, z = sun.distance * sinDeclination;
  const double y = -sun.distance * cosDeclination * sinHour;

  // Parallax: the observer stands on an ellipsoid, Reda & Andreas 2004, eqs. 34 to 36.
  constexpr double kPolarRadius = 0.99664719;         // of the equatorial one
  constexpr double kEarthRadiusInUnits = 4.26345e-5;  // sine of 8.794"
  const double length = std::sqrt(cosLatitude * cosLatitude + kPolarRadius * kPolarRadius * sinLatitude * sinLatitude);
  x -= kEarthRadiusInUnits * cosLatitude / length;
  z -= kEarthRadiusInUnits * kPolarRadius * kPolarRadius * sinLatitude / length;

  const double up = cosLatitude * x + sinLatitude * z, north = cosLatitude * z - sinLatitude * x;
  return {portable::atan2(up, std::sqrt(north * north + y * y)), wholeTurn(portable::atan2(y, north))};
}

SunPosition sunFrom(const PlaceOnEarth& place, const DateTime& time) {
  const double day = julianDay(time);
  return sunFrom(place, day, deltaT(day));
}

double refractionOfAir(double elevation) {
  constexpr double kSet = radians(-0.575);  // the sun's centre appears on the horizon
  const double seen = std::max(elevation, kSet), inDegrees = degrees(seen);
  const double lift = radians(1.02 / 60.0) / portable::tan(radians(inDegrees + 10.3 / (inDegrees + 5.11)));
  // In the zenith the formula is past a right angle, by less than a hundredth of an arc minute.
  if (elevation >= kSet) return std::max(lift, 0.0);
  return lift * portable::tan(kSet) / portable::tan(elevation);
}

}  // namespace parhelion
