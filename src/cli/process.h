// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace parhelion::cli {

/// First of all: makes failures of what the program was started with errors like any other. A file that may
/// not become larger (ulimit -f) is one, no signal. Standard streams that were closed stay useless, but no file that is
/// opened later takes their place, into which messages would go. Signals that ask the program to end have it say so,
/// remove its temporary files and exit with 128 and the signal's number; files that were there stay as they are.
void prepareProcess();

}  // namespace parhelion::cli
