// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>

namespace parhelion {

/// How long something takes, by a clock on the wall that nobody sets.
class RunClock {
 public:
  /// Since it was made.
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace parhelion
