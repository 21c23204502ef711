// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace parhelion {

/// How many of so many threads, the caller's among them, the system lets this process have at the same time: the limit
/// of processes of a user or a container may allow fewer (ulimit -u). They are started once, to see. At least 1.
int startableThreads(int wanted);

/// The most threads that were wanted so far and not to be had, for a word to the user; 0 if none.
int missingThreads();

/// So many threads for parallel loops, at most four a processor: more would only get into each other's way. 0: one a
/// processor.
class Threads {
 public:
  explicit Threads(int threads) : Threads(tbb::this_task_arena::max_concurrency(), threads) {}

  int count() const { return count_; }

  /// The result of f(), whose parallel loops get these threads.
  template <class F>
  auto run(const F& f) {
    return arena_.execute(f);
  }

 private:
  Threads(int processors, int threads)
      : count_(startableThreads(threads > 0 ? std::min(threads, 4 * processors) : processors)),
        limit_(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count_)),
        arena_(count_) {}

  int count_;
  tbb::global_control limit_;  // an arena alone gets no more threads than there are processors
  tbb::task_arena arena_;
};

/// The result of f(), whose parallel loops get so many Threads.
template <class F>
auto withThreads(int threads, const F& f) {
  return Threads(threads).run(f);
}

}  // namespace parhelion
