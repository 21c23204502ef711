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

/// The refractive index behind a surface over that before it, with what else follows from it alone, so that a path
/// works it out once. Made from a plain number.
struct RelativeIndex {
  RelativeIndex(double index)  // NOLINT: numbers are indices
      : eta(index), perEta(1.0 / index), perEta2(1.0 / (index * index)), excess((index - 1.0) * (index + 1.0)) {}

  double eta;
  double perEta, perEta2;  // 1 / eta, 1 / eta^2
  double excess;           // eta^2 - 1
};

/// Fresnel reflectance, the mean of both polarisations. `cosTheta_i` in [0, 1] is taken against the surface. Born &
/// Wolf, section 1.5.
inline Interface fresnel(double cosTheta_i, const RelativeIndex& index) {
  // sin^2 is never formed from 1 - cos^2: at grazing incidence that would cancel.
  const double cos2Theta_t = (index.excess + cosTheta_i * cosTheta_i) * index.perEta2;
  if (cos2Theta_t <= 0.0) return {1.0, 0.0};
  const double cosTheta_t = std::sqrt(cos2Theta_t);
  const double etaCos_t = index.eta * cosTheta_t, etaCos_i = index.eta * cosTheta_i;
  // The amplitudes are quotients, (i - eta t) / (i + eta t) and (eta i - t) / (eta i + t); one division serves both.
  const double sDivisor = cosTheta_i + etaCos_t, pDivisor = etaCos_i + cosTheta_t;
  const double s = (cosTheta_i - etaCos_t) * pDivisor, p = (etaCos_i - cosTheta_t) * sDivisor;
  const double divisor = sDivisor * pDivisor;
  return {std::min(1.0, 0.5 * (s * s + p * p) / (divisor * divisor)), cosTheta_t};
}

/// Direction of the mirrored ray. `normal` is a unit vector, `cosTheta_i` = |lightDir . normal|, and `normal` points to
/// the side the light comes from.
inline Vec3 reflect(const Vec3& lightDir, const Vec3& normal, double cosTheta_i) {
  return lightDir + (2.0 * cosTheta_i) * normal;
}

/// Direction of the refracted ray by Snell's law, with `normal`, `cosTheta_i` and `index` as above.
inline Vec3 refract(const Vec3& lightDir, const Vec3& normal, double cosTheta_i, double cosTheta_t,
                    const RelativeIndex& index) {
  return lightDir * index.perEta + (cosTheta_i * index.perEta - cosTheta_t) * normal;
}

}  // namespace parhelion
