// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "trace/haze_settings.h"

namespace parhelion {

/// How haze scatters light, by the cosine of the angle from where the light was going.
class PhaseFunction {
 public:
  /// Throws std::invalid_argument for a g or a table that is none.
  explicit PhaseFunction(const PhaseSettings& settings);

  /// Per steradian; 1 over the whole sphere.
  double at(double cosine) const;

  /// The cosine at quantile u in (0, 1).
  double cosineAt(double u) const;

 private:
  void tabulate(const PhaseTable& table);

  double g_ = 0.0;
  std::vector<double> value_, below_;  // at equal steps of the angle, and the share of light below each; none for g
};

}  // namespace parhelion
