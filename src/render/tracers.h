// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
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

  /// What traces into the film of `sums`. Threads of each process; 0: its share of its machine's processors. All that
  /// is referred to must outlive it.
  virtual std::unique_ptr<RayTracer> make(const Cloud& cloud, const TraceSettings& settings, RunSums& sums, int threads,
                                          Simd simd);

  /// How many processes there are, this one included. Others can be lost while this one goes on.
  virtual int processes() const { return 1; }

  /// Bytes that the others have sent so far for their sums to be added.
  virtual std::uint64_t bytesReduced() const { return 0; }
};

}  // namespace parhelion
