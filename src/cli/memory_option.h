// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

namespace parhelion::cli {

/// Adds --memory SIZE to a command: what the process is to take at most, instead of what its limits say and a file gets
/// unasked (picture/limits.h). It holds from where the command line is read.
void addMemory(CLI::App& command);

}  // namespace parhelion::cli
