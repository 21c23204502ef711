// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace parhelion {

/// A sum of doubles, held as a 128-bit integer in units of 2^-40. Each term is rounded to a unit; from then on the sum
/// is exact and does not depend on the order of adding.
///
/// A sum lies below 2^87 = 1.5e26. What does not fit throws std::overflow_error: a sum is right, or there is none.
///
/// It is for the few totals of a run. Images use 64 bits (sky/fixed_point.h).
class ExactSum {
 public:
  __extension__ using Units = __int128;
  static constexpr double kScale = 0x1p40;  // units per 1

  void add(double x) {
    const double units = std::nearbyint(x * kScale);
    if (std::abs(units) < 0x1p63)
      addUnits(static_cast<std::int64_t>(units));  // several times as fast
    else if (std::abs(units) < 0x1p127)
      addUnits(static_cast<Units>(units));
    else
      throw std::overflow_error("a sum does not fit into 128 bits: one of its terms is too large, or no number");
  }
  /// Adds whole units.
  void addUnits(Units units) {
    if (__builtin_add_overflow(units_, units, &units_))
      throw std::overflow_error("a sum does not fit into 128 bits: trace fewer rays");
  }
  void merge(const ExactSum& other) { addUnits(other.units_); }
  double value() const { return static_cast<double>(units_) / kScale; }
  bool operator==(const ExactSum&) const = default;

 private:
  Units units_ = 0;
};

}  // namespace parhelion
