// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "math/conventions.h"

namespace parhelion {

/// What a smooth interface does to unpolarised light.
struct Interface {
  double reflectance;  // share of the energy, [0, 1]; 1 when totally reflected
  double cosTheta_t;   // cosine of the transmitted ray with the normal; 0 when totally reflected
};

/// Fresnel reflectance, the mean of both polarisations. `cosTheta_i` in [0, 1] is taken against the surface, `eta` is
/// the index behind the surface over the index before it. Born & Wolf, section 1.5.
inline Interface fresnel(double cosTheta_i, double eta) {
  // sin^2 is never formed from 1 - cos^2: at grazing incidence that would cancel.
  const double cos2Theta_t = ((eta - 1.0) * (eta + 1.0) + cosTheta_i * cosTheta_i) / (eta * eta);
  if (cos2Theta_t <= 0.0) return {1.0, 0.0};
  const double cosTheta_t = std::sqrt(cos2Theta_t);
  const double s = (cosTheta_i - eta * cosTheta_t) / (cosTheta_i + eta * cosTheta_t);
  const double p = (eta * cosTheta_i - cosTheta_t) / (eta * cosTheta_i + cosTheta_t);
  return {std::min(1.0, 0.5 * (s * s + p * p)), cosTheta_t};
}

/// Direction of the mirrored ray. `normal` is a unit vector, `cosTheta_i` = |lightDir . normal|, and `normal` points to
/// the side the light comes from.
inline Vec3 reflect(const Vec3& lightDir, const Vec3& normal, double cosTheta_i) {
  return lightDir + (2.0 * cosTheta_i) * normal;
}

/// Direction of the refracted ray by Snell's law, with `normal`, `cosTheta_i` and `eta` as above.
inline Vec3 refract(const Vec3& lightDir, const Vec3& normal, double cosTheta_i, double cosTheta_t, double eta) {
  return lightDir / eta + (cosTheta_i / eta - cosTheta_t) * normal;
}

}  // namespace parhelion
