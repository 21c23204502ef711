// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "sky/fixed_point.h"

namespace parhelion {

/// The numbers that are stored for each pixel of a tally and each ring of a radial sky. X and Z are relative to the
/// white, so that none can overflow before Y does.
struct TallySlots {
  enum Slot : int { kY, kFirstHalf, kSquares, kHits, kX, kZ };
};

/// So many sums lie in one cache line.
struct alignas(64) SumLine {
  std::array<std::int64_t, 8> place{};

  bool operator==(const SumLine&) const = default;
};

/// The largest sum, as a share of the largest that fits.
inline double fullness(std::span<const SumLine> sums) {
  std::int64_t most = 0;
  for (const SumLine& line : sums)
    for (const std::int64_t sum : line.place) most = std::max(most, sum);
  return static_cast<double>(most) / 0x1p63;
}

/// All their integers, in their order.
inline std::span<std::int64_t> integersOf(std::span<SumLine> lines) {
  static_assert(sizeof(SumLine) == sizeof(SumLine::place));
  return {reinterpret_cast<std::int64_t*>(lines.data()), 8 * lines.size()};
}

/// Adds a line to another, or takes it away where `sign` is -1. Returns whether it did not fit.
template <int sign>
bool combineLine(SumLine& sum, const SumLine& amount) {
  bool overflow = false;
  for (std::size_t k = 0; k < sum.place.size(); ++k)
    overflow |= sign > 0 ? __builtin_add_overflow(sum.place[k], amount.place[k], &sum.place[k])
                         : __builtin_sub_overflow(sum.place[k], amount.place[k], &sum.place[k]);
  return overflow;
}

/// Adds `amounts` to sums of the same number, or takes them away. `forLines` calls its argument with the numbers of all
/// lines that have amounts. Throws std::overflow_error, and changes nothing, where one of them does not fit.
template <int sign, class Sums, class ForLines>
void combineLines(Sums& sums, const Sums& amounts, const ForLines& forLines) {
  bool overflow = false;
  forLines([&](std::size_t i) {
    SumLine sum = std::as_const(sums)[i];
    overflow |= combineLine<sign>(sum, amounts[i]);
  });
  if (overflow) rejectLight();
  forLines([&](std::size_t i) { combineLine<sign>(sums[i], amounts[i]); });
}

inline void addLines(std::vector<SumLine>& sums, const std::vector<SumLine>& amounts) {
  combineLines<1>(sums, amounts, [&](const auto& act) {
    for (std::size_t i = 0; i < sums.size(); ++i) act(i);
  });
}

/// The inverse of addLines(), for sums that contain the amounts.
inline void subtractLines(std::vector<SumLine>& sums, const std::vector<SumLine>& amounts) {
  combineLines<-1>(sums, amounts, [&](const auto& act) {
    for (std::size_t i = 0; i < sums.size(); ++i) act(i);
  });
}

}  // namespace parhelion
