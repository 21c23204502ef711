// SPDX-License-Identifier: Apache-2.0
#include "rays_stage_clock.h"

#include <algorithm>
#include <limits>

namespace parhelion::bench {

StageWatch stageWatch;

namespace {

/// Takes a step; what came before it belongs to one stage, the step itself to another.
template <auto kStep, Stage kBefore, Stage kStage, class... Arguments>
void timed(Arguments... arguments) {
  stageWatch.clock->lap(kBefore);
  (stageWatch.steps->*kStep)(arguments...);
  stageWatch.clock->lap(kStage);
}

/// The same of steps that come in one kind for each PathRecord; benchmarks keep no paths, of ideal crystals.
template <auto kStep, Stage kBefore, Stage kStage, class... Arguments>
void timedPlain(Arguments... arguments) {
  stageWatch.clock->lap(kBefore);
  (stageWatch.steps->*kStep).ideal[0](arguments...);
  stageWatch.clock->lap(kStage);
}

void timedMeasureFaces(const FaceTable& faces, RayPool& pool) {
  stageWatch.clock->lap(Stage::naming);
  if (stageWatch.onNamed) {
    stageWatch.onNamed(pool);
    stageWatch.clock->start();
  }
  stageWatch.steps->measureFaces(faces, pool);
  stageWatch.clock->lap(Stage::intersection);
}

}  // namespace

double StageClock::nanoseconds(Stage stage) const {
  const int i = static_cast<int>(stage);
  return nanoseconds_[i] - ownCost() * static_cast<double>(laps_[i]);
}

double StageClock::ownCost() {
  static const double cost = measureCost();
  return cost;
}

/// That of the fastest of many rows of looks.
double StageClock::measureCost() {
  constexpr int kLaps = 1 << 12;
  double least = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < 64; ++repeat) {
    StageClock clock;
    clock.start();
    for (int i = 0; i < kLaps; ++i) clock.lap(Stage::start);
    least = std::min(least, clock.nanoseconds_[static_cast<int>(Stage::start)] / kLaps);
  }
  return least;
}

LaneSteps timedSteps(const LaneSteps& real) {
  LaneSteps k = real;
  k.draw = timed<&LaneSteps::draw, Stage::start, Stage::start>;
  k.propose = timed<&LaneSteps::propose, Stage::start, Stage::start>;
  k.enter.ideal[0] = timedPlain<&LaneSteps::enter, Stage::start, Stage::entry>;
  k.findFaces = timed<&LaneSteps::findFaces, Stage::pool, Stage::intersection>;
  k.measureFaces = timedMeasureFaces;
  k.meetFaces.ideal[0] = timedPlain<&LaneSteps::meetFaces, Stage::intersection, Stage::optics>;
  k.turnToWorld = timed<&LaneSteps::turnToWorld, Stage::pool, Stage::deposit>;
  return k;
}

int TimedTally::add(const TracedRays& traced) {
  stageWatch.clock->lap(Stage::deposit);
  const int placed = real_.add(traced);
  stageWatch.clock->lap(Stage::deposit);
  return placed;
}

}  // namespace parhelion::bench
