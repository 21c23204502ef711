// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "render/run_sums.h"
#include "trace/ray_tracer.h"

namespace parhelion {

/// Who traces the program's long runs: the threads of this process, as here, or those of many (render/ranks/).
class Tracers {
 public:
  Tracers() = default;
  virtual ~Tracers() = default;
  Tracers(const Tracers&) = delete;
  Tracers& operator=(const Tracers&) = delete;

  /// What traces into the film of `sums`. Threads of each process; 0: its share of its machine's processors. All that is
  /// referred to must outlive it.
  virtual std::unique_ptr<RayTracer> make(const Cloud& cloud, const TraceSettings& settings, RunSums& sums, int threads,
                                          Simd simd);

  /// Whether there are other processes, which can be lost while this one goes on.
  virtual bool areMany() const { return false; }
};

}  // namespace parhelion
