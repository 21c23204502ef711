// SPDX-License-Identifier: Apache-2.0
#include "render/tracing_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "parallel/run_clock.h"

namespace parhelion {

namespace {

// Of the checkpoints that nobody has asked for.
constexpr double kChosenInterval = 600.0;  // s
constexpr double kShortestRun = 1200.0;    // s; a shorter one can as well be traced again
constexpr double kMostShare = 0.01;        // of the run's time

// From so many rays on, the fullest sum tells to a few per mille how it grows; looking is cheap beside tracing them.
constexpr std::uint64_t kFirstLook = 1 << 24;

/// The pauses of a run and what is done in them.
class Run {
 public:
  Run(RayTracer& tracer, Film& film, RayRanges& held, int bundleSize, const RunControl& control)
      : tracer_(tracer), film_(film), held_(held), bundleSize_(bundleSize), control_(control) {}

  RunReport trace(const RayRanges& missing);

 private:
  bool traceRange(RayRange left);
  bool goOn(std::uint64_t done);
  bool checkpointIsDue(double now, std::uint64_t done);
  std::uint64_t raysToLook(std::uint64_t first) const;
  bool isAtErrorCheck() const;
  bool mayBeGoodEnough() const;
  void writeCheckpoint();
  bool lookIsFine();
  bool isGoodEnough();
  void requireRoom();
  void makeResult();
  void reopen();

  RayTracer& tracer_;
  Film& film_;
  RayRanges& held_;
  const int bundleSize_;
  const RunControl& control_;
  const RunClock clock_;

  RunReport report_;
  std::uint64_t wanted_ = 0, done_ = 0;  // rays of this run
  bool finished_ = false;                // the film's result is made of all rays held
  bool checkpointIsDue_ = false;
  double lastCheckpoint_ = 0.0, lastCost_ = 0.0;                        // s
  std::uint64_t measured_ = std::numeric_limits<std::uint64_t>::max();  // rays held when the error was
};

RunReport Run::trace(const RayRanges& missing) {
  finished_ = !held_.empty();
  wanted_ = countOf(missing);
  report_.firstRay = missing.empty() ? 0 : missing.front().first;
  report_.simdLanes = tracer_.simdLanes();
  // A run that was good enough stays so.
  if (!isAtErrorCheck() || !isGoodEnough())
    for (const RayRange& range : missing)
      if (!traceRange(range)) break;
  report_.seconds = clock_.seconds();  // of tracing: the result takes as long for one ray as for many
  makeResult();
  if (control_.goal.error > 0.0 && report_.end != RunEnd::stopped) isGoodEnough();
  static_cast<TraceCounts&>(report_) = tracer_.counts();
  report_.interrupted = report_.end == RunEnd::stopped || report_.end == RunEnd::timeOver;
  return report_;
}

/// False if the run ends here.
bool Run::traceRange(RayRange left) {
  while (left.count > 0) {
    reopen();
    const RayRange part{left.first, std::min(left.count, raysToLook(left.first))};
    const std::uint64_t before = done_, traced = tracer_.trace(part, [&](std::uint64_t n) { return goOn(before + n); });
    done_ = before + traced;
    std::vector<RayRange> all = held_;
    all.push_back({part.first, traced});
    held_ = joined(std::move(all));
    left = {left.first + traced, left.count - traced};
    if (report_.end != RunEnd::complete) return false;
    if (checkpointIsDue_) writeCheckpoint();
    if (traced == part.count && done_ < wanted_ && !lookIsFine()) return false;
  }
  return true;
}

/// After each batch of rays: whether to trace another one.
bool Run::goOn(std::uint64_t done) {
  const double now = clock_.seconds();
  if (control_.onProgress) control_.onProgress(done, now);
  if (done >= wanted_) return true;  // nothing is left to be stopped
  if (control_.stop && *control_.stop)
    report_.end = RunEnd::stopped;
  else if (now >= control_.timeLimit)
    report_.end = RunEnd::timeOver;
  checkpointIsDue_ = checkpointIsDue(now, done);
  return report_.end == RunEnd::complete && !checkpointIsDue_;
}

bool Run::checkpointIsDue(double now, std::uint64_t done) {
  const CheckpointControl& checkpoints = control_.checkpoints;
  if (!checkpoints.write) return false;
  if (checkpoints.requested && checkpoints.requested()) return true;
  const double since = now - lastCheckpoint_;
  if (checkpoints.interval) return since >= *checkpoints.interval;
  const double expected = std::min(control_.timeLimit, now * static_cast<double>(wanted_) / static_cast<double>(done));
  return since >= std::max(kChosenInterval, lastCost_ / kMostShare) && expected >= kShortestRun;
}

void Run::writeCheckpoint() {
  const double before = clock_.seconds();
  makeResult();
  control_.checkpoints.write();
  lastCheckpoint_ = clock_.seconds();
  lastCost_ = lastCheckpoint_ - before;
  checkpointIsDue_ = false;
}

/// The rays from `first` on to the next pause for looking at the sums.
std::uint64_t Run::raysToLook(std::uint64_t first) const {
  const std::uint64_t size = static_cast<std::uint64_t>(bundleSize_), count = countOf(held_);
  if (control_.goal.error > 0.0 && count == first) return nextErrorCheck(first, bundleSize_) - first;
  std::uint64_t look = kFirstLook;
  while (look <= count) look *= 2;
  return (look - count + size - 1) / size * size;
}

/// Whether the rays held are the first ones, and as many as they are when errors are measured.
bool Run::isAtErrorCheck() const {
  if (!(control_.goal.error > 0.0) || held_.size() != 1 || held_[0].first != 0) return false;
  const std::uint64_t count = held_[0].count;
  return count > 0 && count % static_cast<std::uint64_t>(bundleSize_) == 0 &&
         nextErrorCheck(count - 1, bundleSize_) == count;
}

/// False where the error cannot have come down to the goal since it was measured last. Errors fall with the root of the
/// rays or more slowly; as long as most pixels are empty, as one over the rays.
bool Run::mayBeGoodEnough() const {
  if (!report_.error || !std::isfinite(*report_.error)) return true;
  const double more = static_cast<double>(countOf(held_)) / static_cast<double>(measured_);
  return *report_.error <= control_.goal.error * more;
}

/// False if the run ends here.
bool Run::lookIsFine() {
  if (isAtErrorCheck() && mayBeGoodEnough()) {
    makeResult();
    if (isGoodEnough()) return false;
  }
  if (countOf(held_) >= kFirstLook) requireRoom();
  return report_.end == RunEnd::complete;
}

/// Measures the error of the result that is made, unless it has been. True, and the run is to end, if it is small
/// enough or the measuring was stopped.
bool Run::isGoodEnough() {
  if (measured_ != countOf(held_)) {
    report_.error = control_.goal.measure();
    measured_ = countOf(held_);
  }
  if (!report_.error) {
    if (report_.end == RunEnd::complete && done_ < wanted_) report_.end = RunEnd::stopped;
    return true;
  }
  if (*report_.error > control_.goal.error) return false;
  if (isAtErrorCheck() || done_ == wanted_) report_.end = RunEnd::goodEnough;
  return true;
}

/// Throws unless there is room for all rays that are still to come, if the fullest place grows as it has.
void Run::requireRoom() {
  const double held = static_cast<double>(countOf(held_)), all = held + static_cast<double>(wanted_ - done_);
  const auto fits = [&](double full) { return full * all <= held; };
  if (!finished_) {
    tracer_.collect();
    if (fits(film_.fullnessAtMost())) return;
    makeResult();
  }
  const double full = film_.fullness();
  if (fits(full)) return;
  char text[200];
  std::snprintf(text, sizeof text,
                "the fullest place of the result overflows after about %.3g rays, and %.3g are wanted: trace fewer, or "
                "give sun.spectrum fewer wavelengths",
                held / full, all);
  throw std::overflow_error(text);
}

void Run::makeResult() {
  if (finished_) return;
  tracer_.collect();
  film_.finish();
  finished_ = true;
}

void Run::reopen() {
  if (finished_) film_.reopen();
  finished_ = false;
}

}  // namespace

std::uint64_t nextErrorCheck(std::uint64_t rays, int bundleSize) {
  constexpr std::uint64_t kFirst = 100'000;
  const auto size = static_cast<std::uint64_t>(bundleSize);
  const auto whole = [&](std::uint64_t count) { return count / size * size; };
  for (std::uint64_t count = kFirst;; count *= 2) {
    if (whole(count) > rays) return whole(count);
    if (whole(count / 2 * 3) > rays) return whole(count / 2 * 3);
  }
}

RunReport traceRun(RayTracer& tracer, Film& film, RayRanges& held, const RayRanges& missing, int bundleSize,
                   const RunControl& control) {
  return Run(tracer, film, held, bundleSize, control).trace(missing);
}

}  // namespace parhelion
