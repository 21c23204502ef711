// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include "sky/ray_ranges.h"
#include "trace/film.h"
#include "trace/ray_tracer.h"
#include "trace/trace.h"

namespace parhelion {

/// When a run writes down what it has, so that another can go on from there.
struct CheckpointControl {
  /// Writes it. The sums are finished and their ranges of rays right while it is called. Empty: nothing is ever
  /// written.
  std::function<void()> write;

  /// Seconds between the end of one and the beginning of the next. None: ten minutes, but of runs of less than about
  /// twenty there are none, and more than a hundredth of the run's time is not spent on them.
  std::optional<double> interval;

  std::function<bool()> requested;  // whether one is wanted now; asked several times a second
};

/// When a picture is good enough.
struct ErrorGoal {
  double error = 0.0;  // as measured; 0: never

  /// The error of the finished sums; none where it was stopped on the way.
  std::function<std::optional<double>()> measure;
};

struct RunControl : TraceControl {
  CheckpointControl checkpoints;
  ErrorGoal goal;
};

/// Why a run traced no more rays.
enum class RunEnd { complete, stopped, timeOver, goodEnough };

/// How a run went. What TraceReport says is of the rays that it traced itself.
struct RunReport : TraceReport {
  RunEnd end = RunEnd::complete;
  std::optional<double> error;  // as it was measured last; of the result, if there is a goal
};

/// Rays of the fixed numbers at which errors are measured, 100k, 150k, 200k, 300k, 400k, ...: the first one above
/// `rays`, less what is not a whole bundle.
std::uint64_t nextErrorCheck(std::uint64_t rays, int bundleSize);

/// Traces the missing rays of a run into a film, in their order, with pauses for checkpoints and for measuring the
/// error. `held` are the rays that the film's sums have already, whose result is made (Film::finish()); in the end
/// these are all, and their result is made. All ranges start with the first ray of a bundle.
///
/// Errors are measured only when the rays held are the first ones of the sequence without a gap and as many as
/// nextErrorCheck() says, so that a run stops after the same rays on any machine, broken off or not. Checks that cannot
/// but fail, because errors fall as one over the rays at most, are left out. It is measured at the end, too, to tell
/// what was reached.
///
/// Throws std::overflow_error as soon as it can be foreseen that the sums will not hold the light of all the rays.
RunReport traceRun(RayTracer& tracer, Film& film, RayRanges& held, const RayRanges& missing, int bundleSize,
                   const RunControl& control);

}  // namespace parhelion
