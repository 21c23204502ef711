// SPDX-License-Identifier: Apache-2.0
#include "render/tracers.h"

#include "trace/tracer.h"

namespace parhelion {

std::unique_ptr<RayTracer> Tracers::make(const Cloud& cloud, const TraceSettings& settings, RunSums& sums, int threads,
                                         Simd simd) {
  return std::make_unique<Tracer>(cloud, settings, sums.film(), threads, simd);
}

}  // namespace parhelion
