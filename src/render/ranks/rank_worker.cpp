// SPDX-License-Identifier: Apache-2.0
#include <csignal>
#include <exception>
#include <memory>

#include "math/overloaded.h"
#include "parallel/run_clock.h"
#include "render/measured_sums.h"
#include "render/ranks/rank_film.h"
#include "render/ranks/rank_tracers.h"
#include "render/ranks/rank_words.h"
#include "render/sky_sums.h"

namespace parhelion {

namespace {

/// A task in the hands of a rank other than the first.
class RankWorker {
 public:
  RankWorker(Ranks& ranks, const RankTask& task)
      : ranks_(ranks),
        loaded_(parseScene(task.scene, "the scene of rank 0")),
        cloud_(std::holds_alternative<SkyMeasurement>(task.measurement) ? cloudOf(loaded_.scene)
                                                                        : cloudByLight(loaded_.scene)),
        sums_(emptySums(task.measurement)),
        tracer_(cloud_, chosenSettings(cloud_, loaded_.scene.trace), sums_->film(), threadsOf(task, ranks), task.simd) {
  }

  void traceBlocks();
  void collect() { collectFromRanks(ranks_, tracer_, sums_->film()); }

 private:
  std::unique_ptr<RunSums> emptySums(const Measurement& measurement) const;
  void ask(const TimedBlock& last) { ranks_.send(0, Ranks::Subject::request, textOf(last)); }

  Ranks& ranks_;
  LoadedScene loaded_;
  Cloud cloud_;
  std::unique_ptr<RunSums> sums_;
  Tracer tracer_;
};

std::unique_ptr<RunSums> RankWorker::emptySums(const Measurement& measurement) const {
  using Sums = std::unique_ptr<RunSums>;
  return std::visit(
      Overloaded{[&](const SkyMeasurement&) -> Sums { return std::make_unique<SkySums>(loaded_, cloud_); },
                 [&](const MapMeasurement& map) -> Sums {
                   return std::make_unique<MeasuredSums<MapTally>>(
                       [this, map] { return emptyMapTally(loaded_, cloud_, map.binsPerHalfTurn); });
                 },
                 [&](const ProfileMeasurement& profile) -> Sums {
                   return std::make_unique<MeasuredSums<ProfileTally>>([this, profile] {
                     return emptyProfileTally(loaded_, cloud_, profile.bins, profile.from, profile.to);
                   });
                 }},
      measurement);
}

/// Traces what rank 0 deals, until it deals no more. One block is always under way, so that none waits for it.
void RankWorker::traceBlocks() {
  TimedBlock last;
  ask(last);
  RayRange block = blockFromText(ranks_.wait().text);
  while (block.count > 0) {
    ask(last);
    const RunClock clock;
    tracer_.trace(block, [](std::uint64_t) { return true; });
    last = {block.count, clock.seconds()};
    block = blockFromText(ranks_.wait().text);
  }
  ranks_.send(0, Ranks::Subject::done, textOf(last));
}

/// Does `work` and returns why that failed; empty if it did not.
template <class Work>
std::string failureOf(const Work& work) {
  try {
    work();
    return {};
  } catch (const std::exception& error) {
    return error.what();
  }
}

/// Follows the orders of one task. Whatever fails is told when rank 0 waits for this rank.
void serveTask(Ranks& ranks, const std::string& text) {
  std::unique_ptr<RankWorker> worker;
  std::string failure = failureOf([&] { worker = std::make_unique<RankWorker>(ranks, taskFromText(text)); });
  for (std::string order = ranks.wait().text; order != kTaskIsOver; order = ranks.wait().text) {
    if (order == kTraceOrder) {
      if (failure.empty()) failure = failureOf([&] { worker->traceBlocks(); });
      if (!failure.empty()) ranks.send(0, Ranks::Subject::failure, failure);
    } else if (order == kCollectOrder) {
      failure = failureOf([&] { worker->collect(); });
    }
  }
}

}  // namespace

void serveRank0(Ranks& ranks) {
  // Batch systems send them to all processes. Rank 0 knows what to do, and this one's light is needed for it.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGXCPU, SIGPIPE}) std::signal(signal, SIG_IGN);
  for (std::string order = ranks.wait().text; order != kAllIsOver; order = ranks.wait().text)
    if (order.starts_with(kTaskOrder)) serveTask(ranks, order.substr(kTaskOrder.size()));
}

}  // namespace parhelion
