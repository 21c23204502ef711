// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace parhelion::cli {

/// Prints what a tally holds: of what it is, which rays it has and which are missing, what has to be the same for
/// others to be added, and its scene. Returns the exit code. Throws std::runtime_error.
int infoTally(const std::string& path);

}  // namespace parhelion::cli
