// SPDX-License-Identifier: Apache-2.0
// A loop whose calls write to one number without order: the thread sanitizer must find that. With the argument
// "ordered" each writes to its own, and nothing must be found.
#include <atomic>
#include <chrono>
#include <cstddef>
#include <string_view>
#include <thread>
#include <vector>

#include "parallel/loops.h"
#include "parallel/threads.h"

using namespace parhelion;

namespace {

/// Returns once so many threads have come here, or after a second. It gives them no order.
void meet(std::atomic<int>& here, int threads) {
  here.fetch_add(1, std::memory_order_relaxed);
  constexpr int kTries = 1000;
  for (int i = 0; i < kTries && here.load(std::memory_order_relaxed) < threads; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace

int main(int argc, char** argv) {
  const bool ordered = argc > 1 && std::string_view(argv[1]) == "ordered";
  constexpr int kThreads = 2, kRows = 64, kRounds = 100;
  Threads threads(kThreads);
  int racing = 0, sum = 0;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<int> own(kRows, 1);  // written before the loops, counted up in them, read behind them
    std::atomic<int> hereForEach{0}, hereForRows{0};
    threads.run([&] {
      forEach(kRows, [&](int i) {
        meet(hereForEach, kThreads);
        ++(ordered ? own[static_cast<std::size_t>(i)] : racing);
      });
      forRows(kRows, [&](int y) {
        meet(hereForRows, kThreads);
        ++own[static_cast<std::size_t>(y)];
      });
    });
    for (const int value : own) sum += value;
  }
  return !ordered || sum == 3 * kRows * kRounds ? 0 : 1;
}
