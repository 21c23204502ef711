// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "scene/parse_scene.h"
#include "trace/trace.h"

namespace parhelion::cli {

/// What all commands that trace have in common.
struct RunOptions {
  std::string scene;
  std::vector<std::string> overrides;          // -D key=value
  std::string rays, seed, resolution, engine;  // turned into overrides by load(); empty: what the scene says
  double timeLimit = std::numeric_limits<double>::infinity();  // s
  int threads = 0;
  bool quiet = false;
  std::string progress = "auto";  // "auto", "json"
  std::string stats;              // file for the run's figures; empty: none

  /// Adds the scene argument and the options to a subcommand.
  void addTo(CLI::App& command, bool hasImage);

  /// The scene with all overrides applied. Throws SceneError.
  LoadedScene load() const;
};

/// For CLI11: empty where `text` is a whole number from 0 that a scene file can hold, else what was expected.
std::string validWholeNumber(const std::string& text);

/// How a run ended.
struct RunResult {
  TraceReport report;
  bool signalled = false;  // a signal asked it to stop

  int exitCode() const;
};

/// Traces what the scene asks for into `tally`: with progress on stderr, stopping at the batch's end on SIGINT and
/// SIGTERM, with the energy ledger printed and the stats file written at the end.
RunResult runTrace(const RunOptions& options, const Scene& scene, const Cloud& cloud, PathTally& tally);

/// The cloud of a scene.
Cloud makeCloud(const Scene& scene);

}  // namespace parhelion::cli
