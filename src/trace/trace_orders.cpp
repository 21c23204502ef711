// SPDX-License-Identifier: Apache-2.0
#include "trace/trace_orders.h"

#include <algorithm>
#include <atomic>

#include <tbb/enumerable_thread_specific.h>

#include "parallel/loops.h"
#include "parallel/run_clock.h"
#include "parallel/threads.h"

namespace parhelion {

namespace {

// Walks that a thread takes on at a time: few are left in the lanes at the end of each.
constexpr std::uint64_t kPiece = 8192;
// Pieces between two reports of progress.
constexpr std::uint64_t kPiecesTogether = 64;

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
  std::atomic<std::uint64_t> done = 0;
  const std::uint64_t pieces = (walks + kPiece - 1) / kPiece;
  for (std::uint64_t first = 0; first < pieces && (first == 0 || !isStopped()); first += kPiecesTogether) {
    Threads(control.threads).run([&] {
      forEach(std::min(kPiecesTogether, pieces - first), [&](std::uint64_t k) {
        const std::uint64_t begin = (first + k) * kPiece, count = std::min(kPiece, walks - begin);
        if (begin > 0 && isStopped()) return;
        workers.local().walker->follow(begin, count);
        done += count;
      });
    });
    if (control.onProgress) control.onProgress(done, clock.seconds());
  }
  OrderReport report;
  report.walks = done;
  report.interrupted = done < walks;
  for (OrderWorker& worker : workers) {
    film.merge(*worker.film);
    report.energy.merge(worker.walker->ledger());
    report.light.merge(worker.walker->light());
    report.hits += worker.walker->counts().hits;
  }
  report.energy.shareOutDrawn();
  film.finish();
  report.seconds = clock.seconds();
  return report;
}

}  // namespace parhelion
