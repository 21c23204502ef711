// SPDX-License-Identifier: Apache-2.0
#include "cli/thread_words.h"

#include "cli/say.h"
#include "parallel/threads.h"

namespace parhelion::cli {

void countThreads() { startableThreads(tbb::this_task_arena::max_concurrency()); }

void sayMissingThreads() {
  if (const int missing = missingThreads(); missing > 0)
    say("warning: the system let %d %s fewer start than wanted (ulimit -u, or a container's limit of processes)",
        missing, missing == 1 ? "thread" : "threads");
}

}  // namespace parhelion::cli
