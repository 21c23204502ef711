// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>

#include <csignal>

namespace parhelion::cli {

/// What signals ask of the work at hand while this lives. Afterwards they do what they did before.
///
/// - SIGINT, SIGTERM: stop soon. A second one of either ends the program at once.
/// - SIGXCPU, the processor time of a batch system being used up: stop soon.
/// - SIGHUP, the terminal having gone: stop soon and make no more of what was done than a checkpoint.
/// - SIGUSR1: write a checkpoint and go on.
/// - SIGPIPE: nothing. Writing to a reader that has gone fails as any other writing does.
///
/// Signals that the program was started to ignore, as nohup does with SIGHUP, stay ignored. SIGINT is the exception:
/// shells start all jobs in the background so, and who sends it by name means it. There can be only one such object.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  /// Whether to stop soon, for whatever reason.
  const std::atomic<bool>& requested() const;

  /// Whether SIGHUP has come.
  bool hungUp() const;

  /// Whether SIGUSR1 has come since the last call.
  bool takeCheckpointRequest() const;

 private:
  static constexpr std::array kSignals{SIGINT, SIGTERM, SIGXCPU, SIGHUP, SIGUSR1, SIGPIPE};
  std::array<struct sigaction, kSignals.size()> before_;
};

}  // namespace parhelion::cli
