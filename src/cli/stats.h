// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>

#include "picture/transaction.h"
#include "trace/trace.h"
#include "trace/trace_orders.h"
#include "trace/trace_settings.h"

namespace parhelion::cli {

/// Prints on stderr what a run did and how its energy adds up. `timeIsOver`: what ended it early, if anything did, was
/// the time that was asked for.
void printLedger(const TraceReport& report, bool timeIsOver);

/// What is told of a run of tracing.
struct RunFigures {
  TraceSettings settings;
  TraceReport report;
  int threads = 0;          // as asked for; 0: one a processor
  double cpuSeconds = 0.0;  // of the process, when all was traced
};

/// A run's figures, and the most memory that the process has held until now: to be asked for when all work is done.
nlohmann::ordered_json statsJson(const RunFigures& figures);

/// What became of the light that falls on a cloud: shares of it by order, out above and below.
nlohmann::ordered_json ordersJson(const OrderReport& report);

/// Prints on stderr the same in short.
void printOrders(const OrderReport& report);

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
