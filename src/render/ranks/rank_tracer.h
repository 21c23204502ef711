// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "render/ranks/block_deal.h"
#include "render/ranks/rank_task.h"
#include "render/ranks/ranks.h"
#include "trace/tracer.h"

namespace parhelion {

/// Traces with all ranks of a run; lives in rank 0. The others follow its orders in serveRank0().
///
/// Blocks of rays go to whoever is free. The sums stay where they were traced until collect(). That adds them up in a
/// tree: each other rank sends its film's sums once, 64 bytes a pixel of a tally in colour, and is empty afterwards.
///
/// A rank that fails makes trace() and collect() throw std::runtime_error with its number and its reason.
class RankTracer : public RayTracer {
 public:
  /// `film` is that of the task. Everything must outlive the tracer.
  RankTracer(Ranks& ranks, const RankTask& task, const Cloud& cloud, const TraceSettings& settings, Film& film);
  ~RankTracer() override;

  std::uint64_t trace(const RayRange& range, const GoOn& goOn) override;
  void collect() override;
  const TraceCounts& counts() const override { return counts_; }
  int simdLanes() const override { return own_.simdLanes(); }

 private:
  void serve(BlockDeal& deal);
  void requireAllWell() const;

  Ranks& ranks_;
  std::uint64_t bundleSize_;
  Film& film_;
  Tracer own_;
  TraceCounts counts_;
  int busy_ = 0;         // other ranks that have not said yet that they are done
  std::string failure_;  // of the first rank that has failed
};

}  // namespace parhelion
