// SPDX-License-Identifier: Apache-2.0
#include "trace/traced_rays.h"

namespace parhelion {

void ByBundle::sort(const RayQueue& queue, const AlignedVector<double>& ray, int count) {
  members_ = queue.members;
  const auto rankOf = [&](int item) {
    const int of = static_cast<int>(ray[item]);
    return queue.placeOf(of) * members_ + queue.memberOf(of);
  };
  // Counted one rank late, so that filling in leaves each start where it belongs.
  const int ranks = queue.count * members_;
  begin_.assign(ranks + 2, 0);
  for (int item = 0; item < count; ++item) ++begin_[rankOf(item) + 2];
  for (int rank = 2; rank < ranks + 2; ++rank) begin_[rank] += begin_[rank - 1];
  item_.resize(count);
  for (int item = 0; item < count; ++item) item_[begin_[rankOf(item) + 1]++] = item;
}

}  // namespace parhelion
