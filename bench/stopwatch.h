// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

#include <sys/resource.h>

namespace parhelion::bench {

/// Seconds by the clock on the wall, and of all threads of the process together.
struct Timing {
  double seconds = 0.0, cpuSeconds = 0.0;
};

/// Runs from its construction on.
class Stopwatch {
 public:
  Timing read() const {
    return {std::chrono::duration<double>(Clock::now() - start_).count(), cpuSeconds() - cpuStart_};
  }

 private:
  using Clock = std::chrono::steady_clock;

  static double cpuSeconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * t.tv_usec; };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
  }

  Clock::time_point start_ = Clock::now();
  double cpuStart_ = cpuSeconds();
};

}  // namespace parhelion::bench
