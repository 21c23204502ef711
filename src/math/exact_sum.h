// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace parhelion {

/// A sum of doubles, held as a 128-bit integer in units of 2^-kBits. Each term is rounded to a unit; from then on the
/// sum is exact and does not depend on the order of adding.
///
/// A sum lies below 2^(127 - kBits). What does not fit throws std::overflow_error: a sum is right, or there is none.
///
/// It is for the few totals of a run. Images use 64 bits (sky/fixed_point.h).
template <int kBits>
class FixedSum {
 public:
  __extension__ using Units = __int128;
  static constexpr double kScale = static_cast<double>(std::uint64_t{1} << kBits);  // units per 1

  FixedSum() = default;
  explicit FixedSum(Units units) : units_(units) {}

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
  void merge(const FixedSum& other) { addUnits(other.units_); }
  /// Takes out again what merge() has added.
  void subtract(const FixedSum& other) {
    if (__builtin_sub_overflow(units_, other.units_, &units_))
      throw std::overflow_error("a sum does not fit into 128 bits: more is taken out than was in it");
  }
  Units units() const { return units_; }
  double value() const { return static_cast<double>(units_) / kScale; }
  bool operator==(const FixedSum&) const = default;

 private:
  Units units_ = 0;
};

/// Below 2^87 = 1.5e26.
using ExactSum = FixedSum<40>;

}  // namespace parhelion
