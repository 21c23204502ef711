// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "sky/ray_ranges.h"

namespace parhelion {

// What ranks tell each other, besides tasks (rank_task.h).

// Orders of rank 0. The first is followed by a task.
inline constexpr std::string_view kTaskOrder = "task ", kTraceOrder = "trace", kCollectOrder = "collect",
                                  kTaskIsOver = "task is over", kAllIsOver = "all is over";

/// What a rank says of the block before the one that it asks for.
struct TimedBlock {
  std::uint64_t rays = 0;
  double seconds = 0.0;
};

inline std::string textOf(const TimedBlock& block) {
  return std::to_string(block.rays) + ' ' + std::to_string(block.seconds);
}

inline std::string textOf(const RayRange& block) {
  return std::to_string(block.first) + ' ' + std::to_string(block.count);
}

/// Of such a text, as another rank has written it.
inline TimedBlock timedBlockFromText(const std::string& text) {
  std::size_t end = 0;
  const std::uint64_t rays = std::stoull(text, &end);
  return {rays, std::stod(text.substr(end))};
}

inline RayRange blockFromText(const std::string& text) {
  std::size_t end = 0;
  const std::uint64_t first = std::stoull(text, &end);
  return {first, std::stoull(text.substr(end))};
}

}  // namespace parhelion
