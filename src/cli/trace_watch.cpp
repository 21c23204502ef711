// SPDX-License-Identifier: Apache-2.0
#include "cli/trace_watch.h"

#include <cstdio>

#include "cli/commands.h"
#include "cli/stats.h"
#include "math/names.h"

namespace parhelion::cli {

namespace {

/// A line of JSON, or one such as "  8.3 %  250k of 3M rays, 2.1M rays/s, 1 s left".
std::string progressLine(Progress::Style style, double done, double rays, double seconds) {
  const double rate = seconds > 0.0 ? done / seconds : 0.0;
  const double left = rate > 0.0 ? (rays - done) / rate : 0.0;
  char line[200];
  if (style == Progress::Style::json) {
    std::snprintf(
        line, sizeof line,
        "{\"rays\": %.0f, \"of\": %.0f, \"seconds\": %.3f, \"rays_per_second\": %.0f, \"seconds_left\": %.1f}", done,
        rays, seconds, rate, left);
    return line;
  }
  const Readable some = readable(done), all = readable(rays), speed = readable(rate);
  std::snprintf(line, sizeof line, "%5.1f %%  %.3g%s of %.3g%s rays, %.3g%s rays/s, %.0f s left", 100.0 * done / rays,
                some.value, some.suffix, all.value, all.suffix, speed.value, speed.suffix, left);
  return line;
}

}  // namespace

TraceControl traceControl(const RunOptions& options, const StopSignal* stop) {
  TraceControl control;
  control.threads = options.threads;
  control.simd = valueOf<Simd>(options.simd);
  control.timeLimit = options.timeLimit;
  control.stop = stop ? &stop->requested() : nullptr;
  return control;
}

TraceWatch::TraceWatch(const RunOptions& options, std::uint64_t rays, const StopSignal* stop)
    : options_(options),
      rays_(static_cast<double>(rays)),
      stop_(stop),
      progress_(progressStyle(options.quiet, options.progress), Progress::kOfTracing) {}

TraceControl TraceWatch::control() {
  TraceControl control = traceControl(options_, stop_);
  control.onProgress = [this](std::uint64_t count, double seconds) {
    const double done = static_cast<double>(count);
    progress_.update(done / rays_, seconds,
                     [&](Progress::Style style) { return progressLine(style, done, rays_, seconds); });
  };
  return control;
}

int TraceWatch::report(const TracedScene& traced, Transaction& outputs) {
  progress_.finish();
  if (!options_.quiet) printLedger(traced.report);
  if (!options_.stats.empty()) writeStats(outputs.at(options_.stats), traced.settings, traced.report, options_.threads);
  return traced.report.interrupted && stop_ && stop_->requested() ? kInterrupted : kDone;
}

}  // namespace parhelion::cli
