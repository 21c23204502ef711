// SPDX-License-Identifier: Apache-2.0
#include "cli/process.h"

#include <csignal>

#include <fcntl.h>
#include <unistd.h>

namespace parhelion::cli {

void prepareProcess() {
  std::signal(SIGXFSZ, SIG_IGN);
  // The lowest free number is given to what is opened next. Reading and writing fail there as they did before.
  for (int stream = STDIN_FILENO; stream <= STDERR_FILENO; ++stream)
    if (::fcntl(stream, F_GETFD) < 0) ::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

}  // namespace parhelion::cli
