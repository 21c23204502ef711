// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "picture/memory_limit.h"

namespace parhelion {

/// A file in memory that holds an input, for readers that want a path. No input may take more than 128 MB.
inline const std::filesystem::path& inputFile(const std::uint8_t* data, std::size_t size) {
  static const int file = ::memfd_create("input", 0);
  static const std::filesystem::path path = "/proc/self/fd/" + std::to_string(file);
  if (::ftruncate(file, 0) != 0 || ::pwrite(file, data, size, 0) != static_cast<ssize_t>(size)) std::abort();
  constexpr std::uint64_t kMost = 128'000'000;
  setMemoryLimit(kMost);
  return path;
}

/// Readers may refuse an input by a runtime_error and by nothing else.
template <class Read>
void mayRefuse(const Read& read) {
  try {
    read();
  } catch (const std::runtime_error&) {
  }
}

}  // namespace parhelion
