// SPDX-License-Identifier: Apache-2.0
#include "picture/memory_limit.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>

#include "math/number_text.h"

namespace parhelion {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

std::atomic<std::uint64_t> limitOfUser{0};

/// What the process has taken so far, bytes (proc/self/statm).
struct Taken {
  std::uint64_t mapped = 0, resident = 0, data = 0;
};

Taken taken(const fs::path& root) {
  std::ifstream file(root / "proc/self/statm");
  std::uint64_t total = 0, resident = 0, shared = 0, text = 0, library = 0, data = 0;
  file >> total >> resident >> shared >> text >> library >> data;
  const auto page = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  return {total * page, resident * page, data * page};
}

std::uint64_t less(std::uint64_t all, std::uint64_t part) { return all > part ? all - part : 0; }

std::uint64_t resourceLimit(decltype(RLIMIT_AS) resource) {
  rlimit limit{};
  return ::getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY ? limit.rlim_cur : kUnlimited;
}

/// The one number in a file; none for "max" and where there is no such file.
std::optional<std::uint64_t> numberIn(const fs::path& path) {
  std::ifstream file(path);
  std::uint64_t number = 0;
  return file >> number ? std::optional(number) : std::nullopt;
}

/// The number behind a word in a file of lines "word number", 0 if it has none.
std::uint64_t numberBehind(const fs::path& path, std::string_view word) {
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line)) {
    const std::size_t end = line.find(' ');
    if (end != std::string::npos && std::string_view(line).substr(0, end) == word)
      return std::strtoull(line.c_str() + end, nullptr, 10);
  }
  return 0;
}

/// Names of the files of a version of control groups, and the folder that they are in.
struct GroupFiles {
  std::string_view folder, limit, usage, cache;
};
constexpr GroupFiles kVersion1{"sys/fs/cgroup/memory", "memory.limit_in_bytes", "memory.usage_in_bytes",
                               "total_inactive_file"};
constexpr GroupFiles kVersion2{"sys/fs/cgroup", "memory.max", "memory.current", "inactive_file"};

/// What a group and those above it still allow. Within a container the groups above are not seen, and the path may be
/// one from outside.
std::uint64_t allowedInGroup(const fs::path& root, const GroupFiles& files, const fs::path& path) {
  std::uint64_t least = kUnlimited;
  for (fs::path group = path.relative_path();; group = group.parent_path()) {
    const fs::path folder = root / files.folder / group;
    if (const auto limit = numberIn(folder / files.limit)) {
      // The kernel gives back what it keeps of files before it refuses anything.
      const std::uint64_t cached = numberBehind(folder / "memory.stat", files.cache);
      const std::uint64_t used = less(numberIn(folder / files.usage).value_or(0), cached);
      least = std::min(least, less(*limit, used));
    }
    if (group.empty()) return least;
  }
}

std::uint64_t allowedByGroups(const fs::path& root) {
  std::ifstream file(root / "proc/self/cgroup");
  std::uint64_t least = kUnlimited;
  std::string line;  // "4:memory:/path", or of version 2 "0::/path"
  while (std::getline(file, line)) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (first == std::string::npos || second == std::string::npos) continue;
    const std::string controllers = line.substr(first + 1, second - first - 1), path = line.substr(second + 1);
    if (controllers.empty()) least = std::min(least, allowedInGroup(root, kVersion2, path));
    if (("," + controllers + ",").find(",memory,") != std::string::npos)
      least = std::min(least, allowedInGroup(root, kVersion1, path));
  }
  return least;
}

std::uint64_t freeOnMachine(const fs::path& root) {
  constexpr std::uint64_t kKilo = 1024;
  const std::uint64_t available = numberBehind(root / "proc/meminfo", "MemAvailable:");
  return available == 0 ? kUnlimited : kKilo * (available + numberBehind(root / "proc/meminfo", "SwapFree:"));
}

}  // namespace

MemoryLimit memoryLimit(const fs::path& root) {
  const Taken now = taken(root);
  if (const std::uint64_t user = limitOfUser) return {less(user, now.resident), "--memory"};
  MemoryLimit least{kUnlimited, ""};
  const auto add = [&least](std::uint64_t bytes, const char* by) {
    if (bytes < least.bytes) least = {bytes, by};
  };
  if (const std::uint64_t all = resourceLimit(RLIMIT_AS); all != kUnlimited) add(less(all, now.mapped), "ulimit -v");
  if (const std::uint64_t all = resourceLimit(RLIMIT_DATA); all != kUnlimited) add(less(all, now.data), "ulimit -d");
  add(allowedByGroups(root), "the control group (cgroup)");
  add(freeOnMachine(root), "what the machine has free");
  return least;
}

void setMemoryLimit(std::uint64_t bytes) { limitOfUser = bytes; }

void requireMemory(const std::string& what, std::uint64_t bytes) {
  const MemoryLimit limit = memoryLimit();
  if (bytes <= limit.bytes) return;
  throw std::runtime_error(what + " needs about " + byteText(bytes) + " of memory, " + byteText(limit.bytes) +
                           " are allowed by " + limit.by);
}

std::optional<std::uint64_t> bytesIn(std::string_view text) {
  constexpr double kMost = 1e15;
  if (text.ends_with('B')) text.remove_suffix(1);
  double unit = 1.0;
  constexpr std::string_view kSuffixes = "kMGT";
  if (const std::size_t at = text.empty() ? std::string_view::npos : kSuffixes.find(text.back());
      at != std::string_view::npos) {
    for (std::size_t i = 0; i <= at; ++i) unit *= 1000.0;
    text.remove_suffix(1);
  }
  const std::optional<double> number = numberIn(text);
  if (!number || !(*number >= 0.0 && *number * unit <= kMost)) return std::nullopt;
  return static_cast<std::uint64_t>(*number * unit);
}

std::string byteText(std::uint64_t bytes) {
  constexpr std::array kUnits{"bytes", "kB", "MB", "GB", "TB", "PB", "EB"};
  auto value = static_cast<double>(bytes);
  std::size_t unit = 0;
  constexpr double kRoundsUp = 999.5;
  for (; value >= kRoundsUp && unit + 1 < kUnits.size(); ++unit) value /= 1000.0;
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), value < 9.95 && unit > 0 ? "%.1f %s" : "%.0f %s", value, kUnits[unit]);
  return text.data();
}

}  // namespace parhelion
