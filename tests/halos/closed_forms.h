// SPDX-License-Identifier: Apache-2.0
#pragma once

// What halo theory says in closed form, from the refractive index and the sun's elevation alone; radians throughout.

#include <cmath>

#include "math/conventions.h"

namespace parhelion::theory {

/// Least deviation of light by a wedge of angle `wedge`.
inline double leastDeviation(double wedge, double index) {
  return 2.0 * std::asin(index * std::sin(0.5 * wedge)) - wedge;
}

/// Bravais' index: what a wedge's principal section sees of a ray inclined by `inclination` to it.
inline double bravaisIndex(double index, double inclination) {
  const double s = std::sin(inclination);
  return std::sqrt(index * index - s * s) / std::cos(inclination);
}

/// Least deviation by a 60 degree wedge, as a turn about the wedge's edge, of a ray inclined to its section.
inline double leastTurn(double index, double inclination) {
  return leastDeviation(radians(60), bravaisIndex(index, inclination));
}

/// Elevation of the sun above which plates make no parhelia.
inline double lastParhelion(double index) { return std::acos(std::sqrt((index * index - 1.0) / 3.0)); }

/// Elevation of the circumzenithal arc.
inline double circumzenithal(double index, double sunElevation) {
  const double c = std::cos(sunElevation);
  return std::asin(std::sqrt(index * index - c * c));
}

/// Elevation of the circumhorizontal arc.
inline double circumhorizontal(double index, double sunElevation) {
  const double s = std::sin(sunElevation);
  return std::acos(std::sqrt(index * index - s * s));
}

/// Elevation of the upper suncave Parry arc in the sun's vertical: in through the horizontal face, out through one that
/// slopes by 60 degrees.
inline double suncaveParry(double index, double sunElevation) {
  const double inside = std::asin(std::cos(sunElevation) / index);
  return radians(30) + std::asin(index * std::sin(radians(60) - inside));
}

/// Mean share of light reflected at the outside of convex crystals in random orientation: Fresnel's reflectance of
/// unpolarised light averaged over a Lambertian surface. Duntley 1942; Egan & Hilgeman 1979, chapter 4.
inline double externalReflection(double n) {
  const double n2 = n * n, n4 = n2 * n2;
  return 0.5 + (n - 1.0) * (3.0 * n + 1.0) / (6.0 * (n + 1.0) * (n + 1.0)) +
         n2 * (n2 - 1.0) * (n2 - 1.0) / std::pow(n2 + 1.0, 3) * std::log((n - 1.0) / (n + 1.0)) -
         2.0 * n * n2 * (n2 + 2.0 * n - 1.0) / ((n2 + 1.0) * (n4 - 1.0)) +
         8.0 * n4 * (n4 + 1.0) / ((n2 + 1.0) * (n4 - 1.0) * (n4 - 1.0)) * std::log(n);
}

}  // namespace parhelion::theory
