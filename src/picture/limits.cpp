// SPDX-License-Identifier: Apache-2.0
#include "picture/limits.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <system_error>

#include "picture/memory_limit.h"

namespace parhelion {

void requireMemoryFor(const std::filesystem::path& path, std::uint64_t bytes) {
  if (bytes <= kSmallMemory) return;
  if (memoryLimit().by != "--memory") {
    std::error_code none;
    const std::uintmax_t size = std::filesystem::file_size(path, none);
    const std::uint64_t file = none ? 0 : size;
    const std::uint64_t unasked = std::max(kUnaskedMemory, kUnaskedTimesFile * file);
    if (bytes > unasked)
      throw std::runtime_error(path.string() + ": needs about " + byteText(bytes) + " of memory, and a file of " +
                               byteText(file) + " gets at most " + byteText(unasked) +
                               " unasked; --memory SIZE allows more");
  }
  requireMemory(path.string() + ":", bytes);
}

}  // namespace parhelion
