// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "trace/order_walker.h"
#include "trace/trace.h"

namespace parhelion {

/// How walks through a slab went.
struct OrderReport {
  std::uint64_t walks = 0, hits = 0;
  double seconds = 0.0;
  bool interrupted = false;  // stopped before all walks were done: the film is that of fewer
  WalkedLight light;
  OrderLedger energy;
};

/// Follows so many walks through a slab into a film, whose totals of light are the caller's to fill in. Same bits for
/// any number of threads, unless it is stopped; some walks are done all the same. Throws std::overflow_error when the
/// film cannot hold the light.
OrderReport traceOrders(const ManyOrders& slab, std::uint64_t walks, const TraceSettings& settings,
                        const OrderDeposits& deposits, Film& film, const TraceControl& control = {});

}  // namespace parhelion
