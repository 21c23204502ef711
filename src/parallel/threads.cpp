// SPDX-License-Identifier: Apache-2.0
#include "parallel/threads.h"

#include <atomic>
#include <chrono>
#include <filesystem>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace parhelion {
namespace {

std::atomic<int> missing{0};

/// Threads of this process, dying ones included, as the system counts them.
long threadsNow() {
  std::error_code none;
  long count = 0;
  for (auto task = std::filesystem::directory_iterator("/proc/self/task", none);
       !none && task != std::filesystem::directory_iterator(); task.increment(none))
    ++count;
  return count;
}

/// Starts so many threads at once. Returns how many were started; they have ended.
int startAtOnce(int wanted) {
  const long before = threadsNow();
  std::mutex gate;
  std::vector<std::thread> started;
  {
    const std::lock_guard closed(gate);
    try {
      started.reserve(static_cast<std::size_t>(wanted));
      while (static_cast<int>(started.size()) < wanted)
        started.emplace_back([&gate] { const std::lock_guard passed(gate); });
    } catch (const std::system_error&) {  // the system lets no more start
    }
  }
  for (std::thread& thread : started) thread.join();
  // A thread that has been joined still counts for a moment; TBB aborts where it cannot start one.
  constexpr int kTries = 200;
  for (int i = 0; i < kTries && threadsNow() > before; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  return static_cast<int>(started.size());
}

}  // namespace

int startableThreads(int wanted) {
  static std::mutex mutex;
  static int known = 1;    // so many have been seen to start
  static bool all = true;  // more may be possible
  const std::lock_guard lock(mutex);
  if (wanted > known && all) {
    const int started = 1 + startAtOnce(wanted - 1);
    all = started == wanted;
    known = std::max(known, started);
    // For the whole process: Embree has loops of its own.
    if (!all) static const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, known);
  }
  if (wanted > known) missing = std::max(missing.load(), wanted - known);
  return std::min(wanted, known);
}

int missingThreads() { return missing; }

}  // namespace parhelion
