// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <vector>

#include "crystal/angle_quantile.h"
#include "crystal/population_settings.h"
#include "math/tabulated_density.h"

namespace parhelion {

/// One angle or aspect ratio, drawn by inversion: a single number in (0, 1) gives the value.
class ValueSampler {
 public:
  /// Whether a Normal is a density per unit of the value, or per solid angle about a pole at 0 and pi.
  enum class Measure { linear, solidAngle };

  /// A plain value in [lowest, highest], to which Normal, PolarNormal and Laplace are cut off.
  ValueSampler(const AngleDistribution& distribution, Measure measure, double lowest, double highest);

  double sample(double u) const { return quantile_.at(u); }

  /// The same for lanes; valid as long as this.
  const AngleQuantile& quantile() const { return quantile_; }

  /// Probability per unit of the value, before any folding. Infinite where a fixed value sits.
  double density(double x) const;

 private:
  AngleDistribution distribution_;
  std::shared_ptr<const TabulatedDensity> table_;  // Normal, PolarNormal and Laplace of non-zero width
  AngleQuantile quantile_;
};

/// Draws crystal-to-world rotations. Three numbers in (0, 1) a rotation; the first matters most.
class OrientationSampler {
 public:
  explicit OrientationSampler(const OrientationSettings& settings);

  /// Valid as long as this.
  const OrientationQuantile& quantile() const { return quantile_; }

 private:
  std::vector<ValueSampler> angles_;  // what the quantile looks into
  OrientationQuantile quantile_;
};

}  // namespace parhelion
