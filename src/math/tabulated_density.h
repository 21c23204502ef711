// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "math/table_quantile.h"

namespace parhelion {

/// A probability density on [lo, hi] that is linear between equally spaced nodes, sampled by exact inversion.
/// Sampler and density are of one and the same function, so a chi-square test can hold them against each other.
class TabulatedDensity {
 public:
  /// `unnormalised(x)` is evaluated at cells + 1 nodes; it must be finite, nowhere negative and somewhere positive.
  /// Throws std::invalid_argument otherwise.
  TabulatedDensity(const std::function<double(double)>& unnormalised, double lo, double hi, int cells);

  /// The value below which a fraction `u` in [0, 1] of the probability lies.
  double sample(double u) const { return quantile().at(u); }

  /// The same for lanes; valid as long as this.
  TableQuantile quantile() const {
    return {lo_, step_, static_cast<int>(density_.size()) - 1, density_.data(), cumulative_.data(), guide_.data()};
  }

  /// Probability per unit of x; 0 outside [lo, hi].
  double density(double x) const;

  /// Integral of the density from lo to x, in [0, 1].
  double cumulative(double x) const;

  /// Integral of `unnormalised` over [lo, hi] by the same linear pieces.
  double integral() const { return integral_; }

 private:
  double lo_, hi_, step_;
  double integral_ = 0.0;
  std::vector<double> density_;     // at the nodes, normalised
  std::vector<double> cumulative_;  // at the nodes, from 0 to 1
  std::vector<double> guide_;       // guide_[k]: the cell in which cumulative k / cells lies
};

}  // namespace parhelion
