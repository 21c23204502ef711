// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace parhelion {

/// How much memory there is, and who says so.
struct MemoryLimit {
  std::uint64_t bytes = 0;  // that the process may still take
  std::string by;           // "ulimit -v"; empty where nobody says anything
};

/// The least that is allowed: by the processes' limits (ulimit -v and -d), by the control groups that the process is
/// in, and by what the machine has free, swap space included. With setMemoryLimit() that alone counts. `root` is where
/// proc/ and sys/ are.
MemoryLimit memoryLimit(const std::filesystem::path& root = "/");

/// What the whole process is to take at most, whatever limits there are (option --memory). 0: as they say.
void setMemoryLimit(std::uint64_t bytes);

/// Throws std::runtime_error "WHAT needs about 3.1 GB of memory, 2 GB are allowed by ulimit -v" where so many bytes
/// more are too many. For one, before they are allocated.
void requireMemory(const std::string& what, std::uint64_t bytes);

/// "500M", "2.5G" or "4000000000" in bytes: k, M, G and T are powers of 1000, and a B may follow. None for other text,
/// and for more than 1000 TB.
std::optional<std::uint64_t> bytesIn(std::string_view text);

/// "3.1 GB": two digits, in powers of 1000.
std::string byteText(std::uint64_t bytes);

}  // namespace parhelion
