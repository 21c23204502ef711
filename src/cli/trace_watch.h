// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "cli/progress.h"
#include "cli/run_options.h"
#include "cli/stats.h"
#include "cli/stop_signal.h"
#include "render/traced_sky.h"

namespace parhelion::cli {

/// How far a run of tracing is.
struct TraceProgress {
  double done, wanted;          // rays, with those that were there before
  double traced, seconds;       // by this run
  std::optional<double> error;  // of the picture, as measured last
  double goal = 0.0;            // the error that is wanted; 0: none
};

/// A line of JSON, or one such as "  8.3 %  250k of 3M rays, 2.1M rays/s, 1 s left", and ", error 4.1 % of 1 %".
std::string progressLine(Progress::Style style, const TraceProgress& progress);

/// How the options have a run traced: threads, registers, time, stopping at the batch's end on SIGINT and SIGTERM
/// if there is a StopSignal; without a word on stderr.
TraceControl traceControl(const RunOptions& options, const StopSignal* stop);

/// A run of tracing that nobody goes on from, as its user sees it. Signals end the program.
class TraceWatch {
 public:
  /// `rays` is how many there are to be traced. The options must outlive the watch.
  TraceWatch(const RunOptions& options, std::uint64_t rays);

  /// Control of the run, with progress on stderr. Valid as long as the watch.
  TraceControl control();

  /// After the run: prints the energy ledger. Returns what --stats is to tell.
  RunFigures report(const TraceReport& report, const TraceSettings& settings);

 private:
  const RunOptions& options_;
  double rays_;
  Progress progress_;
};

}  // namespace parhelion::cli
