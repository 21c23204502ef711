// SPDX-License-Identifier: Apache-2.0
#include "trace/trace.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include <tbb/enumerable_thread_specific.h>

#include "parallel/loops.h"
#include "parallel/threads.h"

namespace parhelion {

namespace {

// Waves between two looks at the clock and the stop flag: a fraction of a second on one core.
constexpr std::uint64_t kBatch = 64;

/// What one thread keeps to itself.
struct Worker {
  std::unique_ptr<Film> tally;
  std::unique_ptr<Wave> wave;
};

}  // namespace

TraceReport traceRays(const Cloud& cloud, const TraceSettings& settings, std::uint64_t firstRay, Film& tally,
                      const TraceControl& control) {
  const std::uint64_t bundleSize = cloud.bundleSize();
  if (firstRay % bundleSize != 0) throw std::invalid_argument("a run must start with the first ray of a bundle");
  const Intersectors engines = makeIntersectors(cloud, settings.engine);
  Threads threads(control.threads);
  const LaneSteps& steps = laneSteps(control.simd);
  tbb::enumerable_thread_specific<Worker> workers([&] {
    return Worker{tally.forThread(), std::make_unique<Wave>(cloud, engines, settings, steps)};
  });

  TraceReport report;
  report.firstRay = firstRay;
  report.simdLanes = steps.lanes;
  const auto start = std::chrono::steady_clock::now();
  // The run's last bundle may be cut short; it makes a wave of its own.
  const std::uint64_t wholeBundles = settings.rays / bundleSize, waveSize = Wave::bundles(cloud);
  std::uint64_t next = firstRay / bundleSize;
  const int rest = static_cast<int>(settings.rays % bundleSize);
  while (next < wholeBundles && !report.interrupted) {
    const std::uint64_t end = std::min(next + kBatch * waveSize, wholeBundles);
    const std::uint64_t waves = (end - next + waveSize - 1) / waveSize;
    threads.run([&] {
      forEach(waves, [&](std::uint64_t k) {
        Worker& worker = workers.local();
        const std::uint64_t first = next + k * waveSize, count = std::min(waveSize, end - first);
        worker.wave->trace(first, static_cast<int>(count), static_cast<int>(bundleSize), *worker.tally);
      });
    });
    next = end;
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const bool stopped = (control.stop && *control.stop) || report.seconds >= control.timeLimit;
    report.interrupted = stopped && (next < wholeBundles || rest > 0);
    if (control.onProgress) control.onProgress(next * bundleSize - firstRay, report.seconds);
  }
  if (rest > 0 && !report.interrupted) {
    Worker& worker = workers.local();
    worker.wave->trace(wholeBundles, 1, rest, *worker.tally);
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (control.onProgress) control.onProgress(settings.rays - firstRay, report.seconds);
  }

  for (Worker& worker : workers) {
    tally.merge(*worker.tally);
    report.merge(worker.wave->counts());
  }
  tally.finish();
  return report;
}

}  // namespace parhelion
