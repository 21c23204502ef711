// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "crystal/crystal_mesh.h"
#include "trace/exit_list.h"
#include "trace/lane_steps.h"
#include "trace/ray_queue.h"

namespace parhelion {

/// Some bundles of rays of one population, and all the light that has left their crystals.
struct TracedRays {
  const RayQueue& queue;
  const ExitList& exits;
  int members;     // rays per bundle; fewer than the queue has room for if the run ends within a bundle
  int population;  // index into the cloud's
  const CrystalMesh& mesh;
  const LaneSteps& steps;  // for further work on many exits at a time
};

/// Sorts items that belong to rays, such as exits, by their bundles, and in a bundle by its members. The items of the
/// bundle at a place of the queue are item(i), with i from begin(place) up to but not including begin(place + 1).
///
/// Those of one ray stay in their order. So a bundle's items come in an order of their own, whatever other rays were
/// traced beside them, and sums of doubles over them have the same bits however a run is divided.
class ByBundle {
 public:
  /// `ray` holds for each of `count` items the ray that it belongs to (RayQueue::ray()).
  void sort(const RayQueue& queue, const AlignedVector<double>& ray, int count);

  int begin(int place) const { return begin_[place * members_]; }
  int item(int i) const { return item_[i]; }

 private:
  int members_ = 1;
  std::vector<int> begin_, item_;
};

}  // namespace parhelion
