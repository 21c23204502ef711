// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>

#include "sky/tally.h"
#include "trace/wave.h"

namespace parhelion {

/// Traces rays into a film, one range after another: with the threads of this process (trace/tracer.h) or with many
/// processes (render/ranks/). The film's bits depend only on which rays have been traced.
class RayTracer {
 public:
  /// Asked about ten times a second, from the thread that called trace(), with the number of rays traced so far by that
  /// call.
  using GoOn = std::function<bool(std::uint64_t rays)>;

  virtual ~RayTracer() = default;

  /// Traces the first rays of a range, all of them unless `goOn` stops it, and returns how many. A stop takes about a
  /// tenth of a second; whole bundles are traced, unless it is all of the range. Throws std::invalid_argument unless
  /// the range starts with the first ray of a bundle, and std::overflow_error when the film cannot hold the light; then
  /// the film is good for nothing.
  virtual std::uint64_t trace(const RayRange& range, const GoOn& goOn) = 0;

  /// Moves to the film what was traced until now. Tracing may go on afterwards.
  virtual void collect() = 0;

  /// What was done, up to the last collect().
  virtual const TraceCounts& counts() const = 0;

  /// Doubles side by side in the vector registers used.
  virtual int simdLanes() const = 0;
};

}  // namespace parhelion
