// SPDX-License-Identifier: Apache-2.0
#include "trace/traced_rays.h"

namespace parhelion {

void ExitsByBundle::sort(const RayQueue& queue, const ExitList& exits) {
  const auto placeOf = [&](int exit) { return queue.placeOf(static_cast<int>(exits.ray[exit])); };
  // Counted one place late, so that filling in leaves each start where it belongs.
  begin_.assign(queue.count + 2, 0);
  for (int exit = 0; exit < exits.count; ++exit) ++begin_[placeOf(exit) + 2];
  for (int place = 2; place < queue.count + 2; ++place) begin_[place] += begin_[place - 1];
  exit_.resize(exits.count);
  for (int exit = 0; exit < exits.count; ++exit) exit_[begin_[placeOf(exit) + 1]++] = exit;
}

}  // namespace parhelion
