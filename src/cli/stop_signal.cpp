// SPDX-License-Identifier: Apache-2.0
#include "cli/stop_signal.h"

#include <csignal>

namespace parhelion::cli {

namespace {

// Signal handlers reach nothing but globals.
std::atomic<bool> stopRequested{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void onSignal(int signal) {
  stopRequested = true;
  std::signal(signal, SIG_DFL);
}

}  // namespace

StopSignal::StopSignal() {
  stopRequested = false;
  std::signal(SIGINT, onSignal);
  std::signal(SIGTERM, onSignal);
}

StopSignal::~StopSignal() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

const std::atomic<bool>& StopSignal::requested() const { return stopRequested; }

}  // namespace parhelion::cli
