// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "crystal/crystal_mesh.h"
#include "trace/exit_list.h"
#include "trace/lane_steps.h"
#include "trace/ray_queue.h"

namespace parhelion {

/// Some bundles of rays of one population and all the light that has left their crystals.
struct TracedRays {
  const RayQueue& queue;
  const ExitList& exits;
  int members;  // rays a bundle; fewer than the queue has room for where the run's last bundle is cut short
  const CrystalMesh& mesh;
  const LaneSteps& steps;  // for whoever has more to do to many exits at a time
};

/// Puts things that belong to rays in the order of their bundles: those of the bundle at a place of the queue are
/// item(i) for i from begin(place) to below begin(place + 1).
class ByBundle {
 public:
  /// `ray` has the rays of `count` items.
  void sort(const RayQueue& queue, const AlignedVector<double>& ray, int count);

  int begin(int place) const { return begin_[place]; }
  int item(int i) const { return item_[i]; }

 private:
  std::vector<int> begin_, item_;
};

}  // namespace parhelion
