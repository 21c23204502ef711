// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "crystal/angle_quantile.h"
#include "crystal/population_settings.h"
#include "math/tabulated_density.h"

namespace parhelion {

/// One angle or aspect ratio, drawn by inversion: a single number in (0, 1) gives the value.
class ValueSampler {
 public:
  /// A plain value. Where a table is needed, nothing of the distribution lies outside [lowest, highest].
  ValueSampler(const AngleDistribution& distribution, DensityPer per, double lowest, double highest);

  double sample(double u) const { return quantile_.at(u); }

  /// The same for lanes; valid as long as this.
  const AngleQuantile& quantile() const { return quantile_; }

  /// Probability per unit of the value, before any folding. Infinite where a fixed value sits.
  double density(double x) const { return density_(x); }

 private:
  std::function<double(double)> density_;  // holds the table that the quantile looks into
  AngleQuantile quantile_;
};

/// The crystal-to-world rotation at azimuth 0 of crystals that stand alike but for their azimuths, which are free; none
/// of others.
std::optional<RotationColumns<double>> standingOf(const OrientationSettings& settings);

/// Draws crystal-to-world rotations. Three numbers in (0, 1) a rotation; the first matters most.
class OrientationSampler {
 public:
  /// `hasHalfTurn`: whether crystals are the same after half a turn about c.
  explicit OrientationSampler(const OrientationSettings& settings, bool hasHalfTurn = true);

  /// Valid as long as this.
  const OrientationQuantile& quantile() const { return quantile_; }

 private:
  std::vector<ValueSampler> angles_;  // what the quantile looks into
  OrientationQuantile quantile_;
};

}  // namespace parhelion
