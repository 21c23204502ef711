// SPDX-License-Identifier: Apache-2.0
#include "cli/stop_signal.h"

namespace parhelion::cli {

namespace {

// Signal handlers reach nothing but globals.
std::array<struct sigaction, 2> beforeStop;  // what SIGINT and SIGTERM did
std::atomic<bool> stopRequested{false}, hangUp{false}, checkpointRequested{false};
static_assert(std::atomic<bool>::is_always_lock_free);

void setHandler(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  // Calls that wait, such as for a disk, go on: nobody has to look for EINTR.
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

void onStop(int) {
  stopRequested = true;
  // The next one ends the program. What is ignored stays ignored.
  sigaction(SIGINT, &beforeStop[0], nullptr);
  sigaction(SIGTERM, &beforeStop[1], nullptr);
}

// It comes again each second until the hard limit, which cannot be caught.
void onTimeUp(int) { stopRequested = true; }

void onHangUp(int) {
  hangUp = true;
  stopRequested = true;
}

void onCheckpoint(int) { checkpointRequested = true; }

void (*handlerOf(int signal))(int) {
  switch (signal) {
    case SIGXCPU:
      return onTimeUp;
    case SIGHUP:
      return onHangUp;
    case SIGUSR1:
      return onCheckpoint;
    case SIGPIPE:
      return SIG_IGN;
    default:
      return onStop;
  }
}

}  // namespace

StopSignal::StopSignal() {
  stopRequested = hangUp = checkpointRequested = false;
  sigaction(SIGINT, nullptr, &beforeStop[0]);
  sigaction(SIGTERM, nullptr, &beforeStop[1]);
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals[i], nullptr, &before_[i]);
    if (before_[i].sa_handler != SIG_IGN || kSignals[i] == SIGINT) setHandler(kSignals[i], handlerOf(kSignals[i]));
  }
}

StopSignal::~StopSignal() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
}

const std::atomic<bool>& StopSignal::requested() const { return stopRequested; }

bool StopSignal::hungUp() const { return hangUp; }

bool StopSignal::takeCheckpointRequest() const { return checkpointRequested.exchange(false); }

}  // namespace parhelion::cli
