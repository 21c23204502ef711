// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "trace/path_plan.h"
#include "trace/ray_tracer.h"

namespace parhelion {

/// Traces with the threads of this process. What they have made for tracing, they keep between ranges.
class Tracer : public RayTracer {
 public:
  /// `cloud` and `film` must outlive the tracer. Threads 0: one a processor. Throws std::runtime_error when the engine
  /// fails.
  Tracer(const Cloud& cloud, const TraceSettings& settings, Film& film, int threads = 0, Simd simd = Simd::automatic);
  ~Tracer() override;

  std::uint64_t trace(const RayRange& range, const GoOn& goOn) override;

  /// Traces the first rays of a range and returns how many: what takes about a tenth of a second, whole bundles unless
  /// it is all of the range. 0 for an empty range. Throws std::invalid_argument unless the range starts with the first
  /// ray of a bundle, and std::overflow_error when the film cannot hold the light; then the film is good for nothing.
  std::uint64_t traceSome(const RayRange& range);

  void collect() override;
  const TraceCounts& counts() const override { return counts_; }
  int simdLanes() const override { return steps_.lanes; }

 private:
  struct Workers;
  void traceBundles(std::uint64_t first, std::uint64_t count);

  const Cloud& cloud_;
  Film& film_;
  const LaneSteps& steps_;
  Intersectors engines_;
  PathPlan paths_;
  std::unique_ptr<Workers> workers_;
  double batch_;  // bundles that take about a tenth of a second
  TraceCounts counts_;
};

}  // namespace parhelion
