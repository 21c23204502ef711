// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "trace/energy_ledger.h"
#include "trace/engine.h"
#include "trace/path_tally.h"
#include "trace/ray_source.h"

namespace parhelion {

/// What a run did, besides what its tally holds.
struct TraceCounts {
  std::uint64_t rays = 0;
  std::uint64_t hits = 0;      // ray-face encounters
  std::uint64_t deposits = 0;  // exits of light
  std::uint64_t placed = 0;    // PathTally::add()
  std::uint64_t rescued = 0;   // encounters the engine missed and the planes decided
  EnergyLedger energy;

  void merge(const TraceCounts& other);
};

/// Follows many rays at a time through their crystals: rays wait in the queue, some are under way in the pool, their
/// light comes out on the list of exits. For one thread.
class Wave {
 public:
  /// Bundles that a wave is best given at a time: so many that the end of a queue, when few rays are left in the pool,
  /// costs little; so few that all fits into the second-level cache.
  static int bundles(const Cloud& cloud);

  /// `engines` must outlive the wave.
  Wave(const Cloud& cloud, const Engines& engines, const TraceSettings& settings, const LaneSteps& steps);

  /// Traces bundles first ... first + count - 1, count <= bundles(), with so many members each, into `tally`.
  void trace(std::uint64_t first, int count, int members, PathTally& tally);

  const TraceCounts& counts() const { return counts_; }

 private:
  void follow(RayQueue& queue, int population, int members);
  void findFaces(int population);
  bool putNext(RayQueue& queue, int members, int place);
  void refill(RayQueue& queue, int members);
  void settle(RayQueue& queue, int place);
  void count(const RayQueue& queue, int members);

  const Cloud& cloud_;
  const Engines& engines_;
  const LaneSteps& steps_;
  std::uint64_t seed_;
  PathRule rule_;
  RaySource source_;
  std::unique_ptr<RayPool> pool_;
  int nextMember_ = 0, nextPlace_ = 0;  // of the rays in the queue
  ExitList exits_;
  EnergyUnits energy_;
  TraceCounts counts_;
};

}  // namespace parhelion
