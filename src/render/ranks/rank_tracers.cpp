// SPDX-License-Identifier: Apache-2.0
#include "render/ranks/rank_tracers.h"

#include "render/ranks/rank_tracer.h"
#include "render/ranks/rank_words.h"

namespace parhelion {

RankTracers::~RankTracers() { ranks_.order(kAllIsOver); }

std::unique_ptr<RayTracer> RankTracers::make(const Cloud& cloud, const TraceSettings& settings, RunSums& sums,
                                             int threads, Simd simd) {
  const RankTask task{sums.origin().scene, sums.measurement(), threads, simd};
  return std::make_unique<RankTracer>(ranks_, task, cloud, settings, sums.film());
}

}  // namespace parhelion
