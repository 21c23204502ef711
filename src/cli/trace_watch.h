// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/progress.h"
#include "cli/run_options.h"
#include "cli/stop_signal.h"
#include "picture/transaction.h"
#include "render/traced_sky.h"

namespace parhelion::cli {

/// How the options have a run traced: threads, registers, time, stopping at the batch's end on SIGINT and SIGTERM
/// if there is a StopSignal; without a word on stderr.
TraceControl traceControl(const RunOptions& options, const StopSignal* stop);

/// A run of tracing as its user sees it.
class TraceWatch {
 public:
  /// `rays` is how many there are to be traced. Options and signal must outlive the watch.
  TraceWatch(const RunOptions& options, std::uint64_t rays, const StopSignal* stop);

  /// Control of the run, with progress on stderr. Valid as long as the watch.
  TraceControl control();

  /// After the run: prints the energy ledger and writes the stats file as one of the run's outputs. Returns what the
  /// program is to end with, if all else goes well.
  int report(const TracedScene& traced, Transaction& outputs);

 private:
  const RunOptions& options_;
  double rays_;
  const StopSignal* stop_;
  Progress progress_;
};

}  // namespace parhelion::cli
