// SPDX-License-Identifier: Apache-2.0
#include "math/tabulated_density.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace parhelion {

TabulatedDensity::TabulatedDensity(const std::function<double(double)>& unnormalised, double lo, double hi, int cells)
    : lo_(lo), hi_(hi), step_((hi - lo) / cells) {
  if (!(hi > lo) || cells < 1) throw std::invalid_argument("a tabulated density needs lo < hi and at least one cell");
  density_.reserve(static_cast<std::size_t>(cells) + 1);
  for (int i = 0; i <= cells; ++i) {
    const double value = unnormalised(i == cells ? hi : lo + i * step_);
    if (!(value >= 0.0) || !std::isfinite(value)) throw std::invalid_argument("a density must be finite and >= 0");
    density_.push_back(value);
  }

  // Cumulative sums by the trapezoidal rule, which is exact for the linear pieces.
  cumulative_.assign(density_.size(), 0.0);
  for (int i = 0; i < cells; ++i) cumulative_[i + 1] = cumulative_[i] + 0.5 * (density_[i] + density_[i + 1]) * step_;
  integral_ = cumulative_.back();
  if (!(integral_ > 0.0)) throw std::invalid_argument("a density must be positive somewhere");
  for (double& d : density_) d /= integral_;
  for (double& c : cumulative_) c /= integral_;
  cumulative_.back() = 1.0;

  // The guide makes the search for a cell a step or two instead of a bisection.
  int cell = 0;
  guide_.reserve(density_.size());
  for (int k = 0; k <= cells; ++k) {
    while (cell + 1 < cells && cumulative_[cell + 1] <= static_cast<double>(k) / cells) ++cell;
    guide_.push_back(cell);
  }
}

double TabulatedDensity::density(double x) const {
  if (x < lo_ || x > hi_) return 0.0;
  const int cells = static_cast<int>(density_.size()) - 1;
  const int cell = std::min(static_cast<int>((x - lo_) / step_), cells - 1);
  const double t = (x - lo_) / step_ - cell;
  return density_[cell] + t * (density_[cell + 1] - density_[cell]);
}

double TabulatedDensity::cumulative(double x) const {
  if (x <= lo_) return 0.0;
  if (x >= hi_) return 1.0;
  const int cells = static_cast<int>(density_.size()) - 1;
  const int cell = std::min(static_cast<int>((x - lo_) / step_), cells - 1);
  const double t = (x - lo_) / step_ - cell;
  return cumulative_[cell] + step_ * t * (density_[cell] + 0.5 * t * (density_[cell + 1] - density_[cell]));
}

}  // namespace parhelion
