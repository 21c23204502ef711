// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/mman.h>
#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>

#include "picture/memory_limit.h"

namespace parhelion {

/// What an input may take, as long as this lives: a second of the processor, since others may use the machine, too, and
/// 128 MB beside what the process has, since sanitizers and fuzzers take more than the readers.
class Limits {
 public:
  Limits() {
    constexpr std::uint64_t kMost = 128'000'000;  // bytes
    std::ifstream file("/proc/self/statm");
    std::uint64_t all = 0, resident = 0;
    file >> all >> resident;
    setMemoryLimit(resident * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)) + kMost);
    // Our driver has a handler of its own. libFuzzer takes an abort for a crash, and keeps the input.
    if (const auto before = std::signal(SIGVTALRM, [](int) { std::abort(); }); before != SIG_DFL)
      std::signal(SIGVTALRM, before);
    start({1, 0});
  }
  ~Limits() { start({0, 0}); }
  Limits(const Limits&) = delete;
  Limits& operator=(const Limits&) = delete;

 private:
  static void start(timeval time) {
    const itimerval timer{{0, 0}, time};
    ::setitimer(ITIMER_VIRTUAL, &timer, nullptr);
  }
};

/// A file in memory with a path, for what reads and writes files.
class MemoryFile {
 public:
  MemoryFile() : descriptor_(::memfd_create("input", 0)), path_("/proc/self/fd/" + std::to_string(descriptor_)) {}
  ~MemoryFile() { ::close(descriptor_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  /// Becomes empty. It stays the same file.
  const std::filesystem::path& emptied() const {
    if (::ftruncate(descriptor_, 0) != 0 || ::lseek(descriptor_, 0, SEEK_SET) != 0) std::abort();
    return path_;
  }

  const std::filesystem::path& with(const void* data, std::size_t size) const {
    emptied();
    if (::pwrite(descriptor_, data, size, 0) != static_cast<ssize_t>(size)) std::abort();
    return path_;
  }

 private:
  int descriptor_;
  std::filesystem::path path_;
};

/// A file that holds an input, for readers that want a path.
inline const std::filesystem::path& inputFile(const std::uint8_t* data, std::size_t size) {
  static const MemoryFile file;
  return file.with(data, size);
}

/// Readers may refuse an input by a runtime_error and by nothing else. Whether it was taken.
template <class Read>
bool mayRefuse(const Read& read) {
  try {
    read();
    return true;
  } catch (const std::runtime_error&) {
    return false;
  }
}

/// Ends the program where something does not hold that must.
inline void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace parhelion
