// SPDX-License-Identifier: Apache-2.0
#include "render/ranks/rank_tracer.h"

#include <atomic>
#include <chrono>
#include <exception>
#include <stdexcept>
#include <thread>

#include "parallel/run_clock.h"
#include "render/ranks/rank_film.h"
#include "render/ranks/rank_words.h"

namespace parhelion {

namespace {

using Clock = std::chrono::steady_clock;

/// Traces whatever is dealt to rank 0 itself. Meanwhile another thread talks to the other ranks.
void traceOwnBlocks(BlockDeal& deal, Tracer& tracer) {
  for (RayRange block = deal.next(0); block.count > 0; block = deal.next(0)) {
    const RunClock clock;
    tracer.trace(block, [](std::uint64_t) { return true; });
    deal.note(0, block.count, clock.seconds());
  }
}

}  // namespace

RankTracer::RankTracer(Ranks& ranks, const RankTask& task, const Cloud& cloud, const TraceSettings& settings,
                       Film& film)
    : ranks_(ranks),
      bundleSize_(static_cast<std::uint64_t>(cloud.bundleSize())),
      film_(film),
      own_(cloud, settings, film, threadsOf(task, ranks), task.simd) {
  ranks.order(std::string(kTaskOrder) + textOf(task));
}

RankTracer::~RankTracer() { ranks_.order(kTaskIsOver); }

std::uint64_t RankTracer::trace(const RayRange& range, const GoOn& goOn) {
  if (range.first % bundleSize_ != 0) throw std::invalid_argument("a range must start with the first ray of a bundle");
  BlockDeal deal(range, bundleSize_, ranks_.count());
  std::exception_ptr ownFailure;
  std::atomic<bool> ownDone{false};
  std::thread own([&] {
    try {
      traceOwnBlocks(deal, own_);
    } catch (...) {
      ownFailure = std::current_exception();
      deal.close();
    }
    ownDone = true;
  });
  busy_ = ranks_.count() - 1;
  ranks_.order(kTraceOrder);
  try {
    constexpr std::chrono::milliseconds kAskEvery{100};
    Clock::time_point nextQuestion = Clock::now() + kAskEvery;
    while (!ownDone || busy_ > 0) {
      serve(deal);
      if (Clock::now() < nextQuestion) continue;
      nextQuestion += kAskEvery;
      if (!goOn(deal.done())) deal.close();
    }
  } catch (...) {
    deal.close();
    own.join();
    throw;
  }
  own.join();
  if (ownFailure) std::rethrow_exception(ownFailure);
  requireAllWell();
  goOn(deal.dealt());
  return deal.dealt();
}

/// Answers the other ranks' messages, or sleeps for a moment if there are none.
void RankTracer::serve(BlockDeal& deal) {
  constexpr std::chrono::microseconds kMoment{200};
  const std::optional<Ranks::Message> message = ranks_.next();
  if (!message) {
    std::this_thread::sleep_for(kMoment);
    return;
  }
  switch (message->subject) {
    case Ranks::Subject::request: {
      const TimedBlock last = timedBlockFromText(message->text);
      if (last.rays > 0) deal.note(message->from, last.rays, last.seconds);
      ranks_.send(message->from, Ranks::Subject::block, textOf(deal.next(message->from)));
      break;
    }
    case Ranks::Subject::failure:
      if (failure_.empty()) failure_ = "rank " + std::to_string(message->from) + ": " + message->text;
      deal.close();
      --busy_;
      break;
    case Ranks::Subject::done: {
      const TimedBlock last = timedBlockFromText(message->text);
      if (last.rays > 0) deal.note(message->from, last.rays, last.seconds);
      --busy_;
      break;
    }
    case Ranks::Subject::order:
    case Ranks::Subject::block:
      break;  // these go the other way
  }
}

void RankTracer::collect() {
  requireAllWell();
  ranks_.order(kCollectOrder);
  counts_ = collectFromRanks(ranks_, own_, film_);
}

void RankTracer::requireAllWell() const {
  if (!failure_.empty()) throw std::runtime_error(failure_);
}

}  // namespace parhelion
