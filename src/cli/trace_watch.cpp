// SPDX-License-Identifier: Apache-2.0
#include "cli/trace_watch.h"

#include <cmath>
#include <cstdio>

#include "math/names.h"

namespace parhelion::cli {

namespace {

std::string jsonLine(const TraceProgress& p, double rate, double left) {
  char line[300];
  const int length = std::snprintf(
      line, sizeof line,
      "{\"rays\": %.0f, \"of\": %.0f, \"seconds\": %.3f, \"rays_per_second\": %.0f, \"seconds_left\": %.1f", p.done,
      p.wanted, p.seconds, rate, left);
  std::string text(line, static_cast<std::size_t>(length));
  if (p.error && std::isfinite(*p.error)) {
    std::snprintf(line, sizeof line, ", \"error\": %.5g, \"wanted_error\": %.5g", *p.error, p.goal);
    text += line;
  }
  return text + "}";
}

}  // namespace

std::string progressLine(Progress::Style style, const TraceProgress& p) {
  const double rate = p.seconds > 0.0 ? p.traced / p.seconds : 0.0;
  const double left = rate > 0.0 ? (p.wanted - p.done) / rate : 0.0;
  if (style == Progress::Style::json) return jsonLine(p, rate, left);
  const Readable some = readable(p.done), all = readable(p.wanted), speed = readable(rate);
  char line[300];
  std::snprintf(line, sizeof line, "%5.1f %%  %.3g%s of %.3g%s rays, %.3g%s rays/s, %.0f s left",
                100.0 * p.done / p.wanted, some.value, some.suffix, all.value, all.suffix, speed.value, speed.suffix,
                left);
  std::string text = line;
  if (p.error) {
    std::snprintf(line, sizeof line, ", error %.3g %% of %.3g %%", 100.0 * *p.error, 100.0 * p.goal);
    text += line;
  }
  return text;
}

TraceControl traceControl(const RunOptions& options, const StopSignal* stop) {
  TraceControl control;
  control.threads = options.threads;
  control.simd = valueOf<Simd>(options.simd);
  control.timeLimit = options.timeLimit;
  control.stop = stop ? &stop->requested() : nullptr;
  return control;
}

TraceWatch::TraceWatch(const RunOptions& options, std::uint64_t rays)
    : options_(options),
      rays_(static_cast<double>(rays)),
      progress_(progressStyle(options.quiet, options.progress), Progress::kOfTracing) {}

TraceControl TraceWatch::control() {
  TraceControl control = traceControl(options_, nullptr);
  control.onProgress = [this](std::uint64_t count, double seconds) {
    const double done = static_cast<double>(count);
    progress_.update(done / rays_, seconds, [&](Progress::Style style) {
      return progressLine(style, {done, rays_, done, seconds, {}});
    });
  };
  return control;
}

RunFigures TraceWatch::report(const TraceReport& report, const TraceSettings& settings) {
  progress_.finish();
  if (!options_.quiet) printLedger(report, report.seconds >= options_.timeLimit);
  return {settings, report, options_.threads, processUsage().cpuSeconds};
}

}  // namespace parhelion::cli
