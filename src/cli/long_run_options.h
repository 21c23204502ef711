// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/run_options.h"
#include "sky/ray_ranges.h"

namespace parhelion::cli {

/// Adds --error SHARE, for one 1% or 0.01, and what it stands for.
CLI::Option* addErrorGoal(CLI::App& command, std::string& error, const std::string& description);
double errorGoalIn(const std::string& error);

/// Which part of a run is to be traced, from where it goes on, and when it is written down or ends.
struct LongRunOptions {
  std::string slice, rayRange;  // "2/10", "0:5M"; empty: all rays
  std::string resume;           // file; empty: none
  std::string checkpoint;       // time or "none"; empty: as chosen
  std::string error;            // "1%" or "0.01"; empty: none

  std::string tally;  // file for the exact sums; empty: none

  /// What a command's checkpoints are.
  enum class Keeps { output, tallyBeside, tallyByName };

  /// Adds the options to a subcommand: --tally to those that keep their sums by that name only, --error to the others,
  /// which make pictures.
  void addTo(CLI::App& command, Keeps keeps);

  /// The file of --tally, or that of --resume. Throws CLI::ValidationError where checkpoints are asked for and there is
  /// neither.
  std::string tallyFile() const;

  /// The rays of the run, of a scene with so many. Throws CLI::ValidationError if the options do not fit together, or
  /// not to the bundles.
  RayRange wanted(std::uint64_t rays, int bundleSize, const RunOptions& run) const;

  /// Whether a part of the rays only was asked for.
  bool isPart() const { return !slice.empty() || !rayRange.empty(); }

  bool hasCheckpoints() const { return checkpoint != "none"; }
  bool asksForCheckpoints() const { return !checkpoint.empty() && hasCheckpoints(); }

  /// Whether a run leaves a checkpoint, however it ends.
  bool leavesCheckpoint() const { return asksForCheckpoints() || (!resume.empty() && hasCheckpoints()); }

  /// Seconds between checkpoints; none: as chosen.
  std::optional<double> interval() const;

  /// The error at which the picture is good enough; 0: never.
  double goal() const;
};

}  // namespace parhelion::cli
