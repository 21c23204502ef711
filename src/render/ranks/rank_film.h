// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "render/ranks/rank_task.h"
#include "render/ranks/ranks.h"
#include "trace/tracer.h"

namespace parhelion {

/// The threads that a rank traces with.
int threadsOf(const RankTask& task, const Ranks& ranks);

/// Adds up over all ranks what their tracers have done until now. Rank 0's film gets the sums, those of the others are
/// empty afterwards. Returns what was done since the tracers were made: in rank 0 by all of them. All ranks call it at
/// the same time. Where one of them cannot do it, all throw std::overflow_error.
TraceCounts collectFromRanks(Ranks& ranks, Tracer& tracer, Film& film);

}  // namespace parhelion
