// SPDX-License-Identifier: Apache-2.0
#include "trace/traced_rays.h"

namespace parhelion {

void ByBundle::sort(const RayQueue& queue, const AlignedVector<double>& ray, int count) {
  const auto placeOf = [&](int item) { return queue.placeOf(static_cast<int>(ray[item])); };
  // Counted one place late, so that filling in leaves each start where it belongs.
  begin_.assign(queue.count + 2, 0);
  for (int item = 0; item < count; ++item) ++begin_[placeOf(item) + 2];
  for (int place = 2; place < queue.count + 2; ++place) begin_[place] += begin_[place - 1];
  item_.resize(count);
  for (int item = 0; item < count; ++item) item_[begin_[placeOf(item) + 1]++] = item;
}

}  // namespace parhelion
