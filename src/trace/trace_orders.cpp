// SPDX-License-Identifier: Apache-2.0
#include "trace/trace_orders.h"

#include <algorithm>

#include <tbb/enumerable_thread_specific.h>

#include "parallel/loops.h"
#include "parallel/run_clock.h"
#include "parallel/threads.h"

namespace parhelion {

namespace {

// Walks that a thread takes on at a time: few are left in the lanes at the end of each.
constexpr std::uint64_t kPiece = 8192;

struct OrderWorker {
  std::unique_ptr<Film> film;
  std::unique_ptr<OrderWalker> walker;
};

}  // namespace

OrderReport traceOrders(const ManyOrders& slab, std::uint64_t walks, const TraceSettings& settings,
                        const OrderDeposits& deposits, Film& film, const TraceControl& control) {
  const RunClock clock;
  const LaneSteps& steps = laneSteps(control.simd);
  tbb::enumerable_thread_specific<OrderWorker> workers([&] {
    OrderWorker worker{film.forThread(), nullptr};
    worker.walker = std::make_unique<OrderWalker>(slab, settings, deposits, *worker.film, steps);
    return worker;
  });
  const auto isStopped = [&] { return control.stop && *control.stop; };
  Threads(control.threads).run([&] {
    forEach((walks + kPiece - 1) / kPiece, [&](std::uint64_t k) {
      if (!isStopped()) workers.local().walker->follow(k * kPiece, std::min(kPiece, walks - k * kPiece));
    });
  });
  OrderReport report;
  report.walks = walks;
  report.interrupted = isStopped();
  for (OrderWorker& worker : workers) {
    film.merge(*worker.film);
    report.energy.merge(worker.walker->ledger());
    report.light.merge(worker.walker->light());
    report.hits += worker.walker->counts().hits;
  }
  film.finish();
  report.seconds = clock.seconds();
  return report;
}

}  // namespace parhelion
