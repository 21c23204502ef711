// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/tally.h"
#include "stopwatch.h"
#include "trace/cloud.h"
#include "trace/trace.h"

namespace parhelion::bench {

/// An empty tally of the whole sky, `side` x `side` pixels.
Tally wholeSky(const Cloud& cloud, int side);

struct RenderSpeed {
  std::uint64_t rays = 0, hits = 0;
  Timing timing;

  /// Rays a second by the clock on the wall.
  double perSecond() const { return static_cast<double>(rays) / timing.seconds; }

  /// So many in so much time of all processors; 0 where nothing was measured.
  double perCpuSecond(std::uint64_t count) const {
    return timing.cpuSeconds > 0.0 ? static_cast<double>(count) / timing.cpuSeconds : 0.0;
  }
};

/// Traces into a film of the whole sky, `side` x `side` pixels, for about so many seconds.
RenderSpeed renderFor(double seconds, const Cloud& cloud, TraceSettings settings, int side, int threads);

}  // namespace parhelion::bench
