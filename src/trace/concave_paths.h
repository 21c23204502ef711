// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "trace/concave_walk.h"
#include "trace/exit_list.h"
#include "trace/lane_steps.h"
#include "trace/path_plan.h"
#include "trace/ray_queue.h"

namespace parhelion {

/// What is kept of the faces that light has met: as an exit's.
struct PathMark {
  double state = PathAutomaton::kStart;
  PathCode::Words words = {};
};

/// Follows the rays of one population whose crystals are of any form, one after another. For one thread.
class ConcavePaths {
 public:
  struct Counts {
    std::uint64_t hits = 0, rescued = 0;
    ExactSum absorbed;
  };

  /// Fills in the exits of all rays in a queue, and what became of each ray; adds up the energy of both.
  Counts follow(const ConcaveCrystal& crystal, const CrystalOptics& optics, const PathPlan& plan, int population,
                std::uint64_t seed, PathRule rule, int members, RayQueue& queue, ExitList& exits, EnergyUnits& energy);

 private:
  std::vector<ConcaveStep<PathMark>> waiting_;
};

}  // namespace parhelion
