// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/conventions.h"
#include "math/rotation_columns.h"
#include "math/table_quantile.h"

namespace parhelion {

/// A distribution of an angle or an aspect ratio by its inverse, as plain numbers that lanes can run on. A view into a
/// ValueSampler, valid as long as that is.
struct AngleQuantile {
  enum class Kind { linear, arcsine, table } kind;
  double start, width;  // linear: start + u width; arcsine: mean and amplitude
  TableQuantile table;

  /// The value below which a fraction `u` in (0, 1) of the probability lies.
  template <class T>
  PARHELION_INLINE T at(const T& u) const {
    if (kind == Kind::table) return table.at(u);
    if (kind == Kind::linear) return start + u * width;
    return start + width * sincosOfTurnOf(0.5 * (u - 0.5)).sin;
  }

  /// Sine and cosine of at(u).
  template <class T>
  PARHELION_INLINE SineCosine<T> sincos(const T& u) const {
    // A whole turn needs no more than u itself.
    if (kind == Kind::linear && start == 0.0 && width == 2.0 * kPi) return sincosOfTurnOf(u);
    return sincosOfTurnOf(at(u) * (0.5 / kPi));
  }
};

/// How crystals of a population stand, as plain numbers that lanes can run on.
struct OrientationQuantile {
  enum class Kind { random, axis, lowitz } kind;
  // Of the c axis, and about it; for `lowitz` the zenith angle of crystal +y, and the spin about it for the roll.
  AngleQuantile zenith, azimuth, roll;

  /// The crystal-to-world rotation for three numbers in (0, 1); the first matters most.
  template <class T>
  PARHELION_INLINE RotationColumns<T> at(const T& u1, const T& u2, const T& u3) const {
    if (kind == Kind::random) {
      // The cosine of the zenith angle is uniform; this sine is exact near both poles.
      const SineCosine<T> free{2.0 * squareRoot(u1 * (1.0 - u1)), 1.0 - 2.0 * u1};
      return axisRotation(free, sincosOfTurnOf(u2), sincosOfTurnOf(u3));
    }
    // Angles beyond the poles fold back by themselves: the rotation formulas take any angle.
    const SineCosine<T> first = zenith.sincos(u1);
    if (kind == Kind::axis) return axisRotation(first, azimuth.sincos(u2), roll.sincos(u3));
    return spinRotation(SineCosine<T>{first.cos, first.sin}, sincosOfTurnOf(u2), roll.sincos(u3));
  }
};

}  // namespace parhelion
