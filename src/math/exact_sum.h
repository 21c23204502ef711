// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

namespace parhelion {

/// A sum of doubles as a 128-bit integer: exact to 2^-40 a term, the same for any order of adding, and with room for
/// 2^64 terms below 2^23. For the few totals of a run; images and profiles use 64 bits (sky/fixed_point.h).
class ExactSum {
 public:
  static constexpr double kScale = 0x1p40;  // units per 1

  void add(double x) { units_ += static_cast<std::int64_t>(std::nearbyint(x * kScale)); }
  /// Adds units of 1 / kScale.
  void addUnits(std::int64_t units) { units_ += units; }
  void merge(const ExactSum& other) { units_ += other.units_; }
  double value() const { return static_cast<double>(units_) / kScale; }
  bool operator==(const ExactSum&) const = default;

 private:
  __extension__ using Units = __int128;
  Units units_ = 0;
};

}  // namespace parhelion
