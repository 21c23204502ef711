// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <chrono>
#include <cstdint>

#include "trace/film.h"
#include "trace/lane_steps.h"

namespace parhelion::bench {

/// What a wave spends its time on. `naming` is what lies between two steps where Embree is asked: its answers, and
/// before them the pool's refill.
enum class Stage { start, entry, naming, intersection, optics, deposit, pool };
inline constexpr int kStages = 7;

/// Hands all the time of one thread out to stages.
class StageClock {
 public:
  void start() { last_ = Clock::now(); }

  /// The time since the last lap was that of a stage.
  void lap(Stage stage) {
    const Clock::time_point now = Clock::now();
    nanoseconds_[static_cast<int>(stage)] += std::chrono::duration<double, std::nano>(now - last_).count();
    ++laps_[static_cast<int>(stage)];
    last_ = now;
  }

  /// Of all laps, nanoseconds, without what looking at the clock costs.
  double nanoseconds(Stage stage) const;

  /// Of one look at the clock, nanoseconds.
  static double ownCost();

 private:
  using Clock = std::chrono::steady_clock;
  static double measureCost();

  Clock::time_point last_;
  std::array<double, kStages> nanoseconds_{};
  std::array<std::uint64_t, kStages> laps_{};
};

/// What the steps of timedSteps() do beside their work; one thread at a time.
struct StageWatch {
  const LaneSteps* steps = nullptr;  // that do the work
  StageClock* clock = nullptr;
  void (*onNamed)(const RayPool& pool) = nullptr;  // called, off the clock, when the pool's faces have names
};
extern StageWatch stageWatch;

/// LaneSteps that do as stageWatch says; `lanes` is that of the real ones.
LaneSteps timedSteps(const LaneSteps& real);

/// A tally on the clock of stageWatch.
class TimedTally : public Film {
 public:
  explicit TimedTally(Film& real) : real_(real) {}

  int add(const TracedRays& traced) override;
  std::unique_ptr<Film> forThread() override { return std::make_unique<TimedTally>(real_); }
  void merge(Film&) override {}

 private:
  Film& real_;
};

}  // namespace parhelion::bench
