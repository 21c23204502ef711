// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>

namespace parhelion::cli {

/// While it lives, the first SIGINT or SIGTERM asks the run to stop at the end of its batch; a second one ends the
/// program at once.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  const std::atomic<bool>& requested() const;
};

}  // namespace parhelion::cli
