// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/tracers.h"

namespace parhelion::cli {

/// All that a program does after it has been started: reads its command line, runs the command, and says what went
/// wrong. Returns what the process is to end with. `tracers` trace its long runs.
int runProgram(int argc, char** argv, Tracers& tracers);

}  // namespace parhelion::cli
