// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <limits>

#include "trace/wave.h"

namespace parhelion {

/// How a run went.
struct TraceReport : TraceCounts {
  std::uint64_t firstRay = 0;  // traced: firstRay ... firstRay + rays - 1
  int simdLanes = 1;           // doubles side by side in the vector registers used
  double seconds = 0.0;        // wall clock
  bool interrupted = false;    // stopped before all rays were traced
};

/// How a run is watched and stopped. A run stops between batches of rays only, so that what it has traced is a
/// gapless range of ray indices.
struct TraceControl {
  int threads = 0;  // 0: one a processor
  Simd simd = Simd::automatic;
  double timeLimit = std::numeric_limits<double>::infinity();          // seconds
  const std::atomic<bool>* stop = nullptr;                             // set by a signal handler, say
  std::function<void(std::uint64_t done, double seconds)> onProgress;  // after each batch, from the calling thread
};

/// Traces rays firstRay ... settings.rays - 1 of the sequence settings.seed into `tally`. Same bits for any number of
/// threads and for any division into runs. `firstRay` must be the first of its bundle. Throws std::runtime_error when
/// the engine fails, and std::overflow_error when the tally cannot hold the light.
TraceReport traceRays(const Cloud& cloud, const TraceSettings& settings, std::uint64_t firstRay, Film& tally,
                      const TraceControl& control = {});

}  // namespace parhelion
