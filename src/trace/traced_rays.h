// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "crystal/crystal_mesh.h"
#include "trace/exit_list.h"
#include "trace/kernels.h"
#include "trace/ray_queue.h"

namespace parhelion {

/// Some bundles of rays of one population and all the light that has left their crystals.
struct TracedRays {
  const RayQueue& queue;
  const ExitList& exits;
  int members;  // rays a bundle; fewer than the queue has room for where the run's last bundle is cut short
  const CrystalMesh& mesh;
  const Kernels& kernels;  // for whoever has more to do to many exits at a time
};

/// Exits in the order of their bundles: those of the bundle at a place of the queue are exit(i) for i from begin(place)
/// to below begin(place + 1).
class ExitsByBundle {
 public:
  void sort(const RayQueue& queue, const ExitList& exits);

  int begin(int place) const { return begin_[place]; }
  int exit(int i) const { return exit_[i]; }

 private:
  std::vector<int> begin_, exit_;
};

}  // namespace parhelion
