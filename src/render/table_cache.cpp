// SPDX-License-Identifier: Apache-2.0
#include "render/table_cache.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "math/checksum.h"
#include "picture/atomic_file.h"
#include "picture/memory_limit.h"

namespace parhelion {

namespace {

namespace fs = std::filesystem;

// The head of a file: what it is, in which version of this format, and the key of its table.
constexpr std::string_view kFormat = "parhelion table 1\n";
constexpr std::string_view kEnding = ".table";
constexpr std::size_t kDigits = 16;
constexpr std::uint64_t kDefaultBytes = 1'000'000'000;
constexpr const char* kSize = "PARHELION_CACHE_SIZE";

std::string checksumOf(std::string_view bytes) {
  Checksum checksum;
  checksum.add(bytes);
  return hexOf(checksum.value());
}

std::optional<std::string> contentsOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  std::string bytes(std::istreambuf_iterator<char>(file), {});
  if (file.bad()) return std::nullopt;
  return bytes;
}

/// Whether a file has the name of one of ours.
bool isTable(const fs::path& path) {
  return path.extension() == kEnding && path.stem().string().size() == kDigits && fromHex(path.stem().string());
}

struct Kept {
  fs::path path;
  fs::file_time_type used;
  std::uint64_t bytes;
};

std::vector<Kept> tablesIn(const fs::path& folder) {
  std::vector<Kept> all;
  std::error_code none;
  for (fs::directory_iterator one(folder, none), end; !none && one != end; one.increment(none)) {
    std::error_code gone;  // by another process
    const fs::path& path = one->path();
    if (!isTable(path) || !fs::is_regular_file(path, gone)) continue;
    const fs::file_time_type used = fs::last_write_time(path, gone);
    const std::uintmax_t bytes = gone ? 0 : fs::file_size(path, gone);
    if (!gone) all.push_back({path, used, bytes});
  }
  return all;
}

/// As the XDG Base Directory Specification has it: a path that is not absolute counts for nothing.
std::optional<fs::path> cacheFolder() {
  const auto absolute = [](const char* variable) -> std::optional<fs::path> {
    const char* const text = std::getenv(variable);
    if (!text || !fs::path(text).is_absolute()) return std::nullopt;
    return fs::path(text);
  };
  if (const auto cache = absolute("XDG_CACHE_HOME")) return *cache / "parhelion";
  if (const auto home = absolute("HOME")) return *home / ".cache" / "parhelion";
  return std::nullopt;
}

}  // namespace

TableCache::TableCache(fs::path folder, std::uint64_t mostBytes, std::string program)
    : folder_(std::move(folder)), mostBytes_(mostBytes), program_(std::move(program)) {}

std::string TableCache::headOf(std::string_view key) const {
  std::string head(kFormat);
  for (const std::string_view part : {std::string_view(program_), key}) {
    head += std::to_string(part.size()) + '\n';
    head += part;
  }
  return head;
}

fs::path TableCache::pathOf(const std::string& head) const { return folder_ / (checksumOf(head) += kEnding); }

std::optional<std::string> TableCache::find(std::string_view key) const {
  const std::string head = headOf(key);
  const fs::path path = pathOf(head);
  std::optional<std::string> bytes = contentsOf(path);
  if (!bytes || bytes->size() < head.size() + kDigits || !bytes->starts_with(head)) return std::nullopt;
  const std::string checksum = bytes->substr(bytes->size() - kDigits);
  bytes->resize(bytes->size() - kDigits);
  if (checksumOf(*bytes) != checksum) return std::nullopt;
  std::error_code ignored;
  fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
  bytes->erase(0, head.size());
  return bytes;
}

void TableCache::keep(std::string_view key, std::string_view table) const {
  std::string bytes = headOf(key);
  const fs::path path = pathOf(bytes);
  bytes += table;
  bytes += checksumOf(bytes);
  if (bytes.size() > mostBytes_) return;
  try {
    if (fs::create_directories(folder_)) fs::permissions(folder_, fs::perms::owner_all);
    AtomicFile file(path);
    file.write(bytes);
    file.commit();
    makeRoom(path);
  } catch (const std::exception&) {
    // Then the next run has no table of this one.
  }
}

void TableCache::makeRoom(const fs::path& newest) const {
  std::vector<Kept> all = tablesIn(folder_);
  std::ranges::sort(all, {}, &Kept::used);
  std::uint64_t sum = 0;
  for (const Kept& one : all) sum += one.bytes;
  for (const Kept& one : all) {
    if (sum <= mostBytes_) return;
    if (one.path == newest) continue;
    std::error_code ignored;
    fs::remove(one.path, ignored);
    sum -= one.bytes;
  }
}

std::optional<TableCache> tableCacheOfUser() {
  std::uint64_t most = kDefaultBytes;
  if (const char* const text = std::getenv(kSize)) {
    const std::optional<std::uint64_t> bytes = text == std::string_view("off") ? 0 : bytesIn(text);
    if (!bytes)
      throw std::runtime_error(std::string(kSize) + ": expected a size such as 500M or 2G, or off, not '" + text + "'");
    most = *bytes;
  }
  const std::optional<fs::path> folder = cacheFolder();
  if (most == 0 || !folder) return std::nullopt;
  const std::optional<std::string> program = contentsOf("/proc/self/exe");
  if (!program) return std::nullopt;
  return TableCache(*folder, most, checksumOf(*program));
}

}  // namespace parhelion
