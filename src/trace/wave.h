// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "trace/concave_paths.h"
#include "trace/energy_ledger.h"
#include "trace/engine.h"
#include "trace/film.h"
#include "trace/path_plan.h"
#include "trace/ray_source.h"

namespace parhelion {

/// What a run did, besides what its tally holds.
struct TraceCounts {
  std::uint64_t rays = 0;
  std::uint64_t hits = 0;      // ray-face encounters
  std::uint64_t deposits = 0;  // exits of light
  std::uint64_t placed = 0;    // times light found a place in the tally; see Film::add()
  std::uint64_t rescued = 0;   // encounters for which the engine found no face and the planes decided
  EnergyLedger energy;

  void merge(const TraceCounts& other);
  void visitSums(SumVisitor& visitor);
};

/// Follows many rays at a time through their crystals. Rays wait in a queue until there is room in the pool. Those in
/// the pool are inside their crystals. Light that leaves is put on the list of exits. For one thread.
class Wave {
 public:
  /// How many bundles a wave is best given at a time. Few rays are left in the pool at the end of a queue; with this
  /// many bundles that costs little. With more, the data would not fit into the second-level cache.
  static int bundles(const Cloud& cloud);

  /// `engines` and `paths` must outlive the wave.
  Wave(const Cloud& cloud, const Intersectors& engines, const PathPlan& paths, const TraceSettings& settings,
       const LaneSteps& steps);

  /// Traces bundles first ... first + count - 1 into `tally`, of each the first `members` rays. `count` is at most
  /// bundles().
  void trace(std::uint64_t first, int count, int members, Film& tally);

  /// The exits of the rays that somebody else has put into a queue of that population, one a bundle, until the next
  /// call. Bundles must differ in their numbers, which their random numbers depend on.
  ExitList& exitsOf(RayQueue& queue, int population) {
    follow(queue, population, 1);
    return exits_;
  }

  /// What was done since takeCounts() was last called.
  const TraceCounts& counts() const { return counts_; }
  TraceCounts takeCounts() { return std::exchange(counts_, {}); }

 private:
  void traceBlock(std::uint64_t first, int count, int members, Film& tally);
  const Intersector& engine(int population);
  void follow(RayQueue& queue, int population, int members);
  void followConcave(const ConcaveCrystal& crystal, RayQueue& queue, int population, int members);
  void finish(RayQueue& queue, int population, int members);
  void findFaces(int population);
  bool putNext(RayQueue& queue, int population, int members, int place);
  void beginPath(int population, int place);
  void refill(RayQueue& queue, int population, int members);
  void settle(RayQueue& queue, int place);
  void filter(int population);
  void sortByLayer(const RayQueue& queue, int population);

  /// Units of ExactSum in one of `energy_`.
  std::int64_t coarserUnits() const { return static_cast<std::int64_t>(ExactSum::kScale / energy_.perLight); }
  void count(const RayQueue& queue, int members);

  const Cloud& cloud_;
  const Intersectors& engines_;
  const PathPlan& paths_;
  const LaneSteps& steps_;
  std::uint64_t seed_;
  PathRule rule_;
  std::vector<double> perLight_;  // EnergyUnits::perLight of each population
  RaySource source_;

  /// The engine for the crystal of a population whose shape is spread.
  struct OwnEngine {
    std::uint64_t block;
    Intersector engine;
  };
  Engine ownEngine_;
  EngineDevices devices_;
  std::vector<std::optional<OwnEngine>> own_;  // by population
  std::unique_ptr<RayPool> pool_;
  ConcavePaths concavePaths_;
  int nextMember_ = 0, nextPlace_ = 0;  // of the rays in the queue
  bool isIdeal_ = true;                 // whether the crystals are that are being followed
  ExitList exits_;
  EnergyUnits energy_;
  std::vector<std::uint64_t> allowed_;  // by place in the queue: PathPlan::layersFor()
  TraceCounts counts_;
};

}  // namespace parhelion
