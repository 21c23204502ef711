// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/geometric.hpp>

#include "math/conventions.h"
#include "math/lanes.h"

namespace parhelion {

/// What a smooth interface does to unpolarised light; of a single ray, or of the lanes of T.
template <class T>
struct InterfaceOf {
  T reflectance;  // share of the energy, [0, 1]; 1 when totally reflected
  T cosTheta_t;   // cosine of the transmitted ray with the normal; 0 when totally reflected
};

/// The refractive index behind a surface over that before it, with what else follows from it alone, so that a path
/// works it out once. Made from a plain number.
template <class T>
struct RelativeIndexOf {
  RelativeIndexOf(const T& index)  // NOLINT: numbers are indices
      : eta(index), perEta(1.0 / index), perEta2(1.0 / (index * index)), excess((index - 1.0) * (index + 1.0)) {}

  /// On the way out of a medium of index `n`, for those who have `perN` = 1 / n already.
  static PARHELION_INLINE RelativeIndexOf outOf(const T& n, const T& perN) {
    return {perN, n, n * n, (perN - 1.0) * (perN + 1.0)};
  }

  T eta;
  T perEta, perEta2;  // 1 / eta, 1 / eta^2
  T excess;           // eta^2 - 1

 private:
  RelativeIndexOf(const T& eta_, const T& perEta_, const T& perEta2_, const T& excess_)
      : eta(eta_), perEta(perEta_), perEta2(perEta2_), excess(excess_) {}
};
using RelativeIndex = RelativeIndexOf<double>;

/// Fresnel reflectance, the mean of both polarisations. `cosTheta_i` in [0, 1] is taken against the surface. Born &
/// Wolf, section 1.5.
template <class T>
PARHELION_INLINE InterfaceOf<T> fresnel(const T& cosTheta_i, const RelativeIndexOf<T>& index) {
  // sin^2 is never formed from 1 - cos^2: at grazing incidence that would cancel.
  const T cos2Theta_t = (index.excess + cosTheta_i * cosTheta_i) * index.perEta2;
  const MaskOf<T> through = cos2Theta_t > 0.0;
  const T cosTheta_t = squareRoot(select(through, cos2Theta_t, T{}));
  const T etaCos_t = index.eta * cosTheta_t, etaCos_i = index.eta * cosTheta_i;
  // The amplitudes are quotients, (i - eta t) / (i + eta t) and (eta i - t) / (eta i + t); one division serves both.
  const T sDivisor = cosTheta_i + etaCos_t, pDivisor = etaCos_i + cosTheta_t;
  const T s = (cosTheta_i - etaCos_t) * pDivisor, p = (etaCos_i - cosTheta_t) * sDivisor;
  const T divisor = sDivisor * pDivisor;
  const T one = all<T>(1.0), reflectance = lower(0.5 * (s * s + p * p) / (divisor * divisor), one);
  return {select(through, reflectance, one), cosTheta_t};
}

/// Direction of the mirrored ray. `normal` is a unit vector, `cosTheta_i` = |lightDir . normal|, and `normal` points to
/// the side the light comes from. Vector is Vec3, or Triple with T its numbers.
template <class T, class Vector>
PARHELION_INLINE Vector reflect(const Vector& lightDir, const Vector& normal, const T& cosTheta_i) {
  return lightDir + (2.0 * cosTheta_i) * normal;
}

/// Direction of the refracted ray by Snell's law, with `normal`, `cosTheta_i` and `index` as above.
template <class T, class Vector>
PARHELION_INLINE Vector refract(const Vector& lightDir, const Vector& normal, const T& cosTheta_i, const T& cosTheta_t,
                                const RelativeIndexOf<T>& index) {
  return index.perEta * lightDir + (cosTheta_i * index.perEta - cosTheta_t) * normal;
}

/// A vector that rounding alone has put off its length of 1, brought back to it: one step of Newton's method for
/// 1 / sqrt leaves the square of the error.
template <class Vector>
PARHELION_INLINE Vector renormalised(const Vector& v) {
  return (1.5 - 0.5 * dot(v, v)) * v;
}

}  // namespace parhelion
