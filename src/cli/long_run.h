// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "cli/long_run_options.h"
#include "cli/outputs.h"
#include "cli/progress.h"
#include "cli/run_options.h"
#include "cli/stop_signal.h"
#include "picture/transaction.h"
#include "render/tracers.h"
#include "render/tracing_run.h"
#include "trace/trace_orders.h"

namespace parhelion::cli {

/// The outputs of a long run, claimed as claimOutputs() does. A file that is gone on from may be a damaged tally, in
/// which nobody sees who wrote it: it is replaced only if there is an undamaged one before it to go on from.
Transaction claimRun(Files files, const RunOptions& run, const LongRunOptions& longRun);

/// What a long run is about.
struct LongRunTask {
  Tracers& tracers;
  const RunOptions& run;
  const LongRunOptions& longRun;
  const Cloud& cloud;
  TraceSettings settings;                               // as chosen
  RayRange wanted;                                      // rays that are to be in the sums in the end
  std::filesystem::path checkpoint;                     // where checkpoints go; empty: nowhere
  std::function<std::optional<double>()> measureError;  // of the sums' picture; empty: there is none
};

/// A run as its user sees it: it goes on from a tally, traces what is missing with progress on stderr, writes
/// checkpoints, heeds signals, and tells how it went.
class LongRun {
 public:
  /// All that is referred to must outlive it.
  LongRun(LongRunTask task, RunSums& sums, const StopSignal& stop);

  /// Throws CLI::ValidationError where the tally to go on from is none of this run, std::runtime_error where it is
  /// damaged, or the run fails.
  void trace();

  /// After trace(): prints the energy ledger.
  void report() const;

  /// Writes the stats file as one of the outputs, with more members if there are any. To be called when all work is
  /// done: it tells how much memory that took.
  void writeStats(Transaction& outputs, const nlohmann::ordered_json* more = nullptr) const;

  /// Writes the sums as an output of the command, which is to be committed right away. Throws std::runtime_error.
  void writeSums(const Output& output);

  /// Writes the last checkpoint, if this is a run that leaves one and its output is not the checkpoint itself. A file
  /// that cannot be written is one warning.
  void writeLastCheckpoint();

  /// Whether the terminal has gone and all that is to be kept is in the checkpoint.
  bool endsWithoutPicture() const { return stop_.hungUp() && isSaved_; }

  /// What the program is to end with, if all else goes well.
  int exitCode() const;

 private:
  void goOnFromTally();
  void sayWhatIsMissing(const RayRanges& missing);
  RunControl control();
  void showProgress(std::uint64_t done, double seconds);
  std::string progressLine(Progress::Style style, double done, double seconds) const;
  std::optional<double> measureError();
  void checkpointOnTheWay();
  bool tryCheckpoint();
  bool isJson() const;
  void tell(const std::string& text);
  void warn(const std::string& text);
  void tellOfCheckpoint();
  void tellEvent(const nlohmann::ordered_json& event);
  void tellOfLosses();

  LongRunTask task_;
  RunSums& sums_;
  const StopSignal& stop_;
  Progress progress_;
  RunReport report_;
  double cpuSeconds_ = 0.0;       // of the process, when all was traced
  std::uint64_t heldBefore_ = 0;  // of the wanted rays
  std::optional<double> error_;   // as measured last
  bool keepsPrevious_ = true;     // false as long as the checkpoint itself is the damaged one
  bool wroteCheckpoint_ = false, isSaved_ = false, failed_ = false;
  bool toldOfLosses_ = false;
  std::uint64_t raysOnDisk_ = 0;  // in the checkpoint that this run wrote last
};

}  // namespace parhelion::cli
