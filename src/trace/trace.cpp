// SPDX-License-Identifier: Apache-2.0
#include "trace/trace.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace parhelion {

namespace {

// Bundles of rays between two looks at the clock and the stop flag: a fraction of a second on one core.
constexpr std::uint64_t kBatch = 1 << 16;
// Bundles a thread takes at a time.
constexpr std::uint64_t kGrain = 512;

/// What one thread keeps to itself.
struct Worker {
  std::unique_ptr<PathTally> tally;
  std::vector<LightPath> paths;
  TraceReport report;

  void follow(const Cloud& cloud, const Engines& engines, const TraceSettings& settings, std::uint64_t bundle) {
    followBundle(cloud, engines, settings, bundle, paths);
    tally->add(paths);
    for (const LightPath& path : paths) {
      report.rays += 1;
      report.energy.add(path);
      report.hits += path.hits;
      report.deposits += path.exits.size();
      report.rescued += path.rescued;
    }
  }
};

}  // namespace

void EnergyLedger::add(const LightPath& path) {
  in.add(path.incident.weight);
  for (const Exit& exit : path.exits) out.add(exit.energy);
  cutOff.add(path.cutOff);
  lost.add(path.lost);
}

void EnergyLedger::merge(const EnergyLedger& other) {
  in.merge(other.in);
  out.merge(other.out);
  absorbed.merge(other.absorbed);
  cutOff.merge(other.cutOff);
  lost.merge(other.lost);
}

double EnergyLedger::imbalance() const {
  const double all = in.value();
  return all > 0.0 ? (all - out.value() - absorbed.value() - cutOff.value() - lost.value()) / all : 0.0;
}

TraceReport traceRays(const Cloud& cloud, const TraceSettings& settings, std::uint64_t firstRay, PathTally& tally,
                      const TraceControl& control) {
  const std::uint64_t bundleSize = cloud.bundleSize();
  if (firstRay % bundleSize != 0) throw std::invalid_argument("a run must start with the first ray of a bundle");
  const Engines engines = makeEngines(cloud, settings.engine);
  // TBB keeps to the number of processors unless it is told that more threads are wanted.
  // Beyond four a processor they would only get into each other's way.
  const int processors = tbb::this_task_arena::max_concurrency();
  const int threads = control.threads > 0 ? std::min(control.threads, 4 * processors) : processors;
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(threads);
  tbb::enumerable_thread_specific<Worker> workers([&] { return Worker{tally.forThread(), {}, {}}; });

  TraceReport report;
  report.firstRay = firstRay;
  const auto start = std::chrono::steady_clock::now();
  const std::uint64_t endBundle = (settings.rays + bundleSize - 1) / bundleSize;
  std::uint64_t next = firstRay / bundleSize;
  while (next < endBundle && !report.interrupted) {
    const std::uint64_t end = std::min(next + kBatch, endBundle);
    arena.execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::uint64_t>(next, end, kGrain), [&](const auto& block) {
        Worker& worker = workers.local();
        for (std::uint64_t bundle = block.begin(); bundle < block.end(); ++bundle)
          worker.follow(cloud, engines, settings, bundle);
      });
    });
    next = end;
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const bool stopped = (control.stop && *control.stop) || report.seconds >= control.timeLimit;
    report.interrupted = stopped && next < endBundle;
    if (control.onProgress) control.onProgress(std::min(next * bundleSize, settings.rays) - firstRay, report.seconds);
  }

  for (Worker& worker : workers) {
    tally.merge(*worker.tally);
    report.rays += worker.report.rays;
    report.energy.merge(worker.report.energy);
    report.hits += worker.report.hits;
    report.deposits += worker.report.deposits;
    report.rescued += worker.report.rescued;
  }
  return report;
}

}  // namespace parhelion
