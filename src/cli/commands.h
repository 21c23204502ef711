// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

#include <CLI/CLI.hpp>

#include "render/tracers.h"

namespace parhelion::cli {

/// What `parhelion` ends with, as a shell sees it.
enum ExitCode {
  kDone = 0,
  kRunTimeFailure = 1,
  kUsageError = 2,    // also a scene that cannot be used
  kInterrupted = 75,  // stopped by a signal, a sweep by its time, too; what was traced has been written, of a
                      // reconstruction nothing, of a sweep the finished frames
};

/// Arguments that do not fit together, or a file of another kind than is wanted: why, in one line.
struct Unfit : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Each adds one subcommand. Once the command line is parsed, the chosen command runs and stores how it ended in `exit`.
// Long runs are traced by `tracers`.
void addRender(CLI::App& app, int& exit, Tracers& tracers);
void addTrace(CLI::App& app, int& exit, Tracers& tracers);
void addRecon(CLI::App& app, int& exit);
void addMerge(CLI::App& app, int& exit);
void addComposite(CLI::App& app, int& exit);
void addSweep(CLI::App& app, int& exit);
void addView(CLI::App& app, int& exit);
void addProfile(CLI::App& app, int& exit, Tracers& tracers);
void addMap(CLI::App& app, int& exit, Tracers& tracers);
void addPaths(CLI::App& app, int& exit);
void addReplay(CLI::App& app, int& exit);
void addInfo(CLI::App& app, int& exit);
void addCheck(CLI::App& app, int& exit);
void addSchema(CLI::App& app, int& exit);

/// Adds them all.
void addCommands(CLI::App& app, int& exit, Tracers& tracers);

}  // namespace parhelion::cli
