// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

namespace parhelion {

/// A sum of doubles, held as a 128-bit integer in units of 2^-40. Each term is rounded to a unit; from then on the sum
/// is exact and does not depend on the order of adding. There is room for 2^64 terms below 2^23.
///
/// It is for the few totals of a run. Images and profiles use 64 bits (sky/fixed_point.h).
class ExactSum {
 public:
  void add(double x) { units_ += static_cast<std::int64_t>(std::nearbyint(x * kScale)); }
  /// Adds whole units.
  void addUnits(std::int64_t units) { units_ += units; }
  void merge(const ExactSum& other) { units_ += other.units_; }
  double value() const { return static_cast<double>(units_) / kScale; }
  bool operator==(const ExactSum&) const = default;

 private:
  static constexpr double kScale = 0x1p40;
  __extension__ using Units = __int128;
  Units units_ = 0;
};

}  // namespace parhelion
