// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

namespace parhelion {

/// A term of a periodic series: amplitude * cos(phase + rate * t), t in Julian millennia from J2000.
struct SeriesTerm {
  double amplitude;  // 1e-8 rad, or 1e-8 astronomical units
  double phase;      // rad
  double rate;       // rad a millennium
};

// The earth as seen from the sun, in the ecliptic of date: the series at index i is multiplied by t^i.
extern const std::array<std::span<const SeriesTerm>, 6> kEarthLongitude;
extern const std::array<std::span<const SeriesTerm>, 2> kEarthLatitude;
extern const std::array<std::span<const SeriesTerm>, 5> kEarthRadius;

/// A term of the nutation in 1e-4 arc seconds, t in Julian centuries from J2000: in longitude
/// (longitude + longitudeRate * t) * sin(angle), in obliquity (obliquity + obliquityRate * t) * cos(angle), where the
/// angle is the sum of multiples of the five fundamental angles.
struct NutationTerm {
  std::array<double, 5> multiples;
  double longitude, longitudeRate;
  double obliquity, obliquityRate;
};

extern const std::span<const NutationTerm> kNutation;

}  // namespace parhelion
