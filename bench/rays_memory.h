// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace parhelion::bench {

/// Makes the peak start anew from what the process holds now (Linux: writes to /proc/self/clear_refs). Throws
/// std::runtime_error where the system does not let it.
void resetPeakMemory();

/// Most memory resident since then, bytes.
std::size_t peakMemory();

/// Memory that is free on this machine now, bytes.
std::size_t freeMemory();

}  // namespace parhelion::bench
