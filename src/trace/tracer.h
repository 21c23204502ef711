// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "sky/tally.h"
#include "trace/wave.h"

namespace parhelion {

/// Traces rays into a film, one range after another. What its threads have made for tracing, they keep between ranges.
/// The film's bits depend only on which rays have been traced, not on threads, ranges or their order.
class Tracer {
 public:
  /// `cloud` and `film` must outlive the tracer. Threads 0: one a processor. Throws std::runtime_error when the engine
  /// fails.
  Tracer(const Cloud& cloud, const TraceSettings& settings, Film& film, int threads = 0, Simd simd = Simd::automatic);
  ~Tracer();

  /// Traces the first rays of a range and returns how many: what takes about a tenth of a second, whole bundles unless
  /// it is all of the range. 0 for an empty range. Throws std::invalid_argument unless the range starts with the first
  /// ray of a bundle, and std::overflow_error when the film cannot hold the light; then the film is good for nothing.
  std::uint64_t traceSome(const RayRange& range);

  /// Moves to the film what the threads still hold. Until then the film lacks an unknown part of the light. Tracing may
  /// go on afterwards.
  void collect();

  /// What was done, up to the last collect().
  const TraceCounts& counts() const { return counts_; }

  /// Doubles side by side in the vector registers used.
  int simdLanes() const;

 private:
  struct Workers;
  void traceBundles(std::uint64_t first, std::uint64_t count);

  const Cloud& cloud_;
  Film& film_;
  const LaneSteps& steps_;
  Intersectors engines_;
  std::unique_ptr<Workers> workers_;
  double batch_;  // bundles that take about a tenth of a second
  TraceCounts counts_;
};

}  // namespace parhelion
