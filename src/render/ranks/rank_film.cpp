// SPDX-License-Identifier: Apache-2.0
#include "render/ranks/rank_film.h"

#include <algorithm>
#include <exception>
#include <thread>

#include "sky/fixed_point.h"

namespace parhelion {

int threadsOf(const RankTask& task, const Ranks& ranks) {
  if (task.threads > 0) return task.threads;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()) / ranks.onThisMachine());
}

TraceCounts collectFromRanks(Ranks& ranks, Tracer& tracer, Film& film) {
  bool failed = false;
  try {
    tracer.collect();
  } catch (const std::exception&) {
    failed = true;  // a sum did not fit; the others must not wait for this rank's
  }
  if (ranks.inAny(failed)) rejectLight();
  film.visitSums(ranks);
  TraceCounts counts = tracer.counts();
  counts.visitSums(ranks);
  ranks.requireNoOverflow();
  return counts;
}

}  // namespace parhelion
