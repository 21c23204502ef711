// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace parhelion {

/// The result of f(), whose parallel loops get so many threads, at most four a processor: more would only get into
/// each other's way. 0: one a processor.
template <class F>
auto withThreads(int threads, const F& f) {
  const int processors = tbb::this_task_arena::max_concurrency();
  const int count = threads > 0 ? std::min(threads, 4 * processors) : processors;
  // An arena alone gets no more threads than there are processors.
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
  return tbb::task_arena(count).execute(f);
}

}  // namespace parhelion
