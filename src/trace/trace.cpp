// SPDX-License-Identifier: Apache-2.0
#include "trace/trace.h"

#include <algorithm>

#include "parallel/run_clock.h"
#include "trace/tracer.h"

namespace parhelion {

TraceReport traceRays(const Cloud& cloud, const TraceSettings& settings, std::uint64_t firstRay, Film& tally,
                      const TraceControl& control) {
  Tracer tracer(cloud, settings, tally, control.threads, control.simd);
  TraceReport report;
  report.firstRay = firstRay;
  report.simdLanes = tracer.simdLanes();
  const RunClock clock;
  const RayRange range{firstRay, settings.rays - std::min(firstRay, settings.rays)};
  const std::uint64_t traced = tracer.trace(range, [&](std::uint64_t rays) {
    report.seconds = clock.seconds();
    if (control.onProgress) control.onProgress(rays, report.seconds);
    return !(control.stop && *control.stop) && report.seconds < control.timeLimit;
  });
  report.interrupted = traced < range.count;
  tracer.collect();
  static_cast<TraceCounts&>(report) = tracer.counts();
  tally.finish();
  return report;
}

}  // namespace parhelion
