// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
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
inline double fullness(const std::vector<SumLine>& sums) {
  std::int64_t most = 0;
  for (const SumLine& line : sums)
    for (const std::int64_t sum : line.place) most = std::max(most, sum);
  return static_cast<double>(most) / 0x1p63;
}

/// All their integers, in their order.
inline std::span<std::int64_t> integersOf(std::vector<SumLine>& lines) {
  static_assert(sizeof(SumLine) == sizeof(SumLine::place));
  return {reinterpret_cast<std::int64_t*>(lines.data()), 8 * lines.size()};
}

/// Adds `amounts` to sums of the same number. Throws std::overflow_error, and changes nothing, where one of them does
/// not fit.
inline void addLines(std::vector<SumLine>& sums, const std::vector<SumLine>& amounts) {
  std::int64_t sum = 0;
  bool overflow = false;
  for (std::size_t i = 0; i < sums.size(); ++i)
    for (std::size_t k = 0; k < 8; ++k) overflow |= __builtin_add_overflow(sums[i].place[k], amounts[i].place[k], &sum);
  if (overflow) rejectLight();
  for (std::size_t i = 0; i < sums.size(); ++i)
    for (std::size_t k = 0; k < 8; ++k) sums[i].place[k] += amounts[i].place[k];
}

/// Takes `amounts` out of sums that contain them: the inverse of addLines(). Throws std::overflow_error as that does.
inline void subtractLines(std::vector<SumLine>& sums, const std::vector<SumLine>& amounts) {
  std::int64_t sum = 0;
  bool overflow = false;
  for (std::size_t i = 0; i < sums.size(); ++i)
    for (std::size_t k = 0; k < 8; ++k) overflow |= __builtin_sub_overflow(sums[i].place[k], amounts[i].place[k], &sum);
  if (overflow) rejectLight();
  for (std::size_t i = 0; i < sums.size(); ++i)
    for (std::size_t k = 0; k < 8; ++k) sums[i].place[k] -= amounts[i].place[k];
}

}  // namespace parhelion
