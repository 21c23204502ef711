// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <variant>

#include "crystal/population_settings.h"
#include "math/portable.h"
#include "math/tabulated_density.h"

namespace parhelion {

/// One angle or aspect ratio, drawn by inversion: a single number in (0, 1) gives the value.
class ValueSampler {
 public:
  /// Whether a Normal is a density per unit of the value, or per solid angle about a pole at 0 and pi.
  enum class Measure { linear, solidAngle };

  /// A plain value in [lowest, highest], to which Normal, PolarNormal and Laplace are cut off.
  ValueSampler(const AngleDistribution& distribution, Measure measure, double lowest, double highest);

  double sample(double u) const;

  /// Sine and cosine of sample(u).
  portable::SinCos sincos(double u) const;

  /// Probability per unit of the value, before any folding. Infinite where a fixed value sits.
  double density(double x) const;

 private:
  AngleDistribution distribution_;
  bool fullTurn_ = false;                          // uniform from 0 to 2 pi
  std::shared_ptr<const TabulatedDensity> table_;  // Normal, PolarNormal and Laplace of non-zero width
};

/// Draws crystal-to-world rotations. Three numbers in (0, 1) a rotation; the first matters most.
class OrientationSampler {
 public:
  explicit OrientationSampler(const OrientationSettings& settings);

  Mat3 sample(double u1, double u2, double u3) const;

 private:
  struct Random {};
  struct Axis {
    ValueSampler zenith, azimuth, roll;
  };
  struct Lowitz {
    ValueSampler axisZenith, spin;
  };
  using Kind = std::variant<Random, Axis, Lowitz>;
  static Kind build(const OrientationSettings& settings);

  Kind kind_;
};

}  // namespace parhelion
