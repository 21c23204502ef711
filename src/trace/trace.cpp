// SPDX-License-Identifier: Apache-2.0
#include "trace/trace.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace parhelion {

namespace {

// Rays between two looks at the clock and the stop flag: a fraction of a second on one core.
constexpr std::uint64_t kBatch = 1 << 17;
// Rays a thread takes at a time.
constexpr std::uint64_t kGrain = 1024;

/// What one thread keeps to itself.
struct Worker {
  std::unique_ptr<PathTally> tally;
  LightPath path;
  TraceReport report;
};

void followInto(Worker& worker, const Cloud& cloud, const Engines& engines, const TraceSettings& settings,
                std::uint64_t index) {
  followRay(cloud, engines, settings, index, worker.path);
  worker.tally->add(worker.path);
  worker.report.energy.add(worker.path);
  worker.report.hits += worker.path.hits;
  worker.report.deposits += worker.path.exits.size();
  worker.report.rescued += worker.path.rescued;
}

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
  const Engines engines = makeEngines(cloud, settings.engine);
  // TBB keeps to the number of processors unless it is told that more threads are wanted.
  const int threads = control.threads > 0 ? control.threads : tbb::this_task_arena::max_concurrency();
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(threads);
  tbb::enumerable_thread_specific<Worker> workers([&] { return Worker{tally.forThread(), {}, {}}; });

  TraceReport report;
  report.firstRay = firstRay;
  const auto start = std::chrono::steady_clock::now();
  std::uint64_t next = firstRay;
  while (next < settings.rays && !report.interrupted) {
    const std::uint64_t end = std::min(next + kBatch, settings.rays);
    arena.execute([&] {
      tbb::parallel_for(tbb::blocked_range<std::uint64_t>(next, end, kGrain), [&](const auto& block) {
        Worker& worker = workers.local();
        for (std::uint64_t index = block.begin(); index < block.end(); ++index)
          followInto(worker, cloud, engines, settings, index);
      });
    });
    next = end;
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (control.onProgress) control.onProgress(next - firstRay, report.seconds);
    const bool stopped = (control.stop && *control.stop) || report.seconds >= control.timeLimit;
    report.interrupted = stopped && next < settings.rays;
  }

  report.rays = next - firstRay;
  for (const Worker& worker : workers) {
    tally.merge(*worker.tally);
    report.energy.merge(worker.report.energy);
    report.hits += worker.report.hits;
    report.deposits += worker.report.deposits;
    report.rescued += worker.report.rescued;
  }
  return report;
}

}  // namespace parhelion
