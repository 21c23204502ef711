// SPDX-License-Identifier: Apache-2.0
#include "cli/process.h"

#include <csignal>
#include <string_view>

#include <fcntl.h>
#include <unistd.h>

#include "picture/temporary_file.h"

namespace parhelion::cli {

namespace {

void onEnd(int signal) {
  removeTemporaryFiles();
  constexpr std::string_view kWords = "parhelion: interrupted\n";
  [[maybe_unused]] const auto told = ::write(STDERR_FILENO, kWords.data(), kWords.size());
  constexpr int kBySignal = 128;  // as shells have it
  ::_exit(kBySignal + signal);
}

void endBySignals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) {
    struct sigaction action {};
    ::sigaction(signal, nullptr, &action);
    // Shells start jobs in the background with SIGINT ignored, and who sends it by name means it.
    if (action.sa_handler == SIG_IGN && signal != SIGINT) continue;
    action.sa_handler = onEnd;
    ::sigaction(signal, &action, nullptr);
  }
}

}  // namespace

void prepareProcess() {
  endBySignals();
  std::signal(SIGXFSZ, SIG_IGN);
  // The lowest free number is given to what is opened next. Reading and writing fail there as they did before.
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

}  // namespace parhelion::cli
