// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "trace/order_walker.h"
#include "trace/trace.h"

namespace parhelion {

/// How walks through a slab went.
struct OrderReport {
  std::uint64_t walks = 0, hits = 0;
  double seconds = 0.0;
  bool interrupted = false;  // stopped before all walks were done: then the film is good for nothing
  WalkedLight light;
  OrderLedger energy;
};

/// Follows so many walks through a slab into a film, whose totals of light are the caller's to fill in. Same bits for
/// any number of threads. Throws std::overflow_error when the film cannot hold the light.
OrderReport traceOrders(const ManyOrders& slab, std::uint64_t walks, const TraceSettings& settings,
                        const OrderDeposits& deposits, Film& film, const TraceControl& control = {});

}  // namespace parhelion
