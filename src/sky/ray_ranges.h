// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace parhelion {

/// Rays first, first + 1, ..., first + count - 1.
struct RayRange {
  std::uint64_t first = 0;
  std::uint64_t count = 0;

  /// The number after the last ray's.
  std::uint64_t end() const { return first + count; }

  bool operator==(const RayRange&) const = default;
};

/// Ranges in ascending order, of which none is empty and no two overlap or touch. All functions but joined() take such.
using RayRanges = std::vector<RayRange>;

/// The ranges in ascending order. Ranges that touch are joined, empty ones dropped. Throws std::invalid_argument if two
/// overlap or a number is beyond 2^64 - 1.
RayRanges joined(std::vector<RayRange> ranges);

/// How many rays there are in all ranges together.
std::uint64_t countOf(const RayRanges& ranges);

/// The first range of rays that is in both.
std::optional<RayRange> commonRays(const RayRanges& a, const RayRanges& b);

/// The rays of `all` that are not among `taken`. The latter may have others, too.
RayRanges raysWithout(const RayRanges& all, const RayRanges& taken);

/// "rays 0 to 99 and 200", as messages name them; of many ranges the first few and how many more there are.
std::string wordsFor(const RayRanges& ranges);

}  // namespace parhelion
