// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>

#include "picture/transaction.h"
#include "trace/trace.h"
#include "trace/trace_settings.h"

namespace parhelion::cli {

/// Prints on stderr what a run did and how its energy adds up.
void printLedger(const TraceReport& report);

/// The run's figures; `threads` 0 is one a processor.
nlohmann::ordered_json statsJson(const TraceSettings& settings, const TraceReport& report, int threads);

/// What the process has used so far.
struct ProcessUsage {
  double cpuSeconds;         // of all threads, user and system
  std::uint64_t peakMemory;  // bytes
};
ProcessUsage processUsage();

/// The number of threads that `asked` stands for: 0 is one a processor.
int threadCount(int asked);

/// Writes JSON (writeText). Throws std::runtime_error.
void writeJson(const Output& output, const nlohmann::ordered_json& json);

}  // namespace parhelion::cli
