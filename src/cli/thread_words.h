// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace parhelion::cli {

/// Finds out how many threads there may be, before a library starts its own.
void countThreads();

/// A word on stderr where there were fewer threads than wanted.
void sayMissingThreads();

}  // namespace parhelion::cli
