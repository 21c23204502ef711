// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace parhelion {

/// Light in equal bins of an angle, added in triangles.
class AngleBins {
 public:
  /// `bins` of them over [from, to] (rad); light outside falls into none.
  AngleBins(int bins, double from, double to)
      : from_(from), perBin_(bins / (to - from)), light_(static_cast<std::size_t>(bins)) {}

  /// Adds light at one angle.
  void add(double angle, double light) {
    const double place = (angle - from_) * perBin_;
    if (place >= 0.0 && place <= size())
      light_[static_cast<std::size_t>(place < size() ? place : size() - 1.0)] += light;
  }

  /// Adds the light of a triangle, across which both angle and density are linear, from their values at its corners.
  /// The mean of the densities is all its light.
  void addTriangle(const double* angle, const double* density);

  /// Whether angles from `low` to `high` lie in any bin.
  bool reaches(double low, double high) const {
    return (high - from_) * perBin_ >= 0.0 && (low - from_) * perBin_ <= size();
  }

  /// Of a bin, rad.
  double width() const { return 1.0 / perBin_; }

  const std::vector<double>& light() const { return light_; }

 private:
  double size() const { return static_cast<double>(light_.size()); }

  double from_, perBin_;
  std::vector<double> light_;
};

}  // namespace parhelion
