// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <doctest/doctest.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>

namespace parhelion {

/// Megabytes of memory that `work` takes at its peak, seen in a process of its own, which has no earlier peak; 255 for
/// all that is more. It throws nothing and checks nothing.
template <typename Work>
int megabytesOf(Work work) {
  const auto peak = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
  };
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    const long before = peak();
    work();
    ::_exit(static_cast<int>(std::min(peak() - before, 255L)));
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  REQUIRE(WIFEXITED(status));
  return WEXITSTATUS(status);
}

}  // namespace parhelion
