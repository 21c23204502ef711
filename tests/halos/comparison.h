// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "trace/sky_map.h"

namespace parhelion {

/// Chi-square of pairs of sums that ought to agree, each with its standard error.
class Disagreement {
 public:
  /// Counts a pair when its light together stands out of the noise far enough for its error to be known.
  void add(double a, double errorOfA, double b, double errorOfB) {
    constexpr double kLeast = 8.0;  // standard errors, some 64 rays
    const double variance = errorOfA * errorOfA + errorOfB * errorOfB;
    if (!(variance > 0.0) || (a + b) * (a + b) < kLeast * kLeast * variance) return;
    chiSquare_ += (a - b) * (a - b) / variance;
    ++compared_;
  }

  int compared() const { return compared_; }

  /// Standard deviations by which the chi-square lies above its mean (Wilson & Hilferty's normal approximation).
  double sigmas() const {
    const double variance = 2.0 / (9.0 * compared_);
    return (std::cbrt(chiSquare_ / compared_) - (1.0 - variance)) / std::sqrt(variance);
  }

 private:
  double chiSquare_ = 0.0;
  int compared_ = 0;
};

/// Compares two maps of the same grid from independent runs, bin by bin.
inline Disagreement compareMaps(const SkyMap& a, const SkyMap& b) {
  Disagreement sum;
  for (int row = 0; row < a.rows(); ++row)
    for (int column = 0; column < a.columns(); ++column)
      sum.add(a.energy(column, row), a.error(column, row), b.energy(column, row), b.error(column, row));
  return sum;
}

}  // namespace parhelion
