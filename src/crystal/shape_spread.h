// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <string_view>
#include <variant>

#include "crystal/distributions.h"

namespace parhelion {

/// exp(-ln(x / median)^2 / 2 sigma^2) per unit of ln x; x > 0.
struct LogNormal {
  static constexpr DistributionWords kWords{"lognormal", "median", "sigma"};
  double median = 1.0;
  double sigma = 0.0;  // of ln x
};

/// Of lengths, distances, heights and slopes.
using LengthDistribution = std::variant<FixedValue, Normal, UniformRange, Laplace, LogNormal>;

/// What of a crystal's shape may be spread.
enum class ShapeLength { aspect, upper, lower, slope, upperSlope, lowerSlope, sides };

constexpr std::string_view nameOf(ShapeLength what) {
  switch (what) {
    case ShapeLength::aspect:
      return "aspect";
    case ShapeLength::upper:
      return "upper";
    case ShapeLength::lower:
      return "lower";
    case ShapeLength::slope:
      return "slope";
    case ShapeLength::upperSlope:
      return "upper slope";
    case ShapeLength::lowerSlope:
      return "lower slope";
    case ShapeLength::sides:
      return "sides";
  }
  return {};
}

/// Whether it is an angle, rad.
constexpr bool isSlope(ShapeLength what) {
  return what == ShapeLength::slope || what == ShapeLength::upperSlope || what == ShapeLength::lowerSlope;
}

/// Something about a crystal's shape that differs from crystal to crystal.
struct ShapeSpread {
  ShapeLength what;
  std::array<bool, 6> sides;  // of `sides`: those that are drawn as one, from face 3 on
  LengthDistribution distribution;
};

/// Limits of what may be drawn, beyond which distributions are cut off; slopes in rad.
struct LengthLimits {
  double lowest, highest;
};
LengthLimits limitsOf(ShapeLength what);

/// Values of one spread by inversion.
class LengthSampler {
 public:
  explicit LengthSampler(const ShapeSpread& spread) : LengthSampler(spread.distribution, limitsOf(spread.what)) {}

  /// Throws std::invalid_argument where all of the distribution lies beyond the limits.
  LengthSampler(const LengthDistribution& distribution, const LengthLimits& limits);

  /// The value below which a fraction `u` in (0, 1) of what is drawn lies.
  double at(double u) const;

 private:
  std::function<double(double)> quantile_;
};

}  // namespace parhelion
