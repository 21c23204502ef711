// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "beam/ring_integral.h"

namespace parhelion {

/// Tables in files that runs leave to later ones. Whatever keeps one from being read or written, a damaged file, a
/// folder that cannot be written, another process that does the same, it is as if there were no such file: nothing is
/// said and nothing fails. Several processes may use a folder at the same time.
class TableCache {
 public:
  /// Of tables that `program` makes, in a folder that need not exist yet. All files in it together take at most so many
  /// bytes; those go first that were used last a long time ago.
  TableCache(std::filesystem::path folder, std::uint64_t mostBytes, std::string program);

  /// The table of that key, as it was kept.
  std::optional<std::string> find(std::string_view key) const;

  /// Keeps a table.
  void keep(std::string_view key, std::string_view table) const;

 private:
  std::string headOf(std::string_view key) const;
  std::filesystem::path pathOf(const std::string& head) const;
  void makeRoom(const std::filesystem::path& newest) const;

  std::filesystem::path folder_;
  std::uint64_t mostBytes_;
  std::string program_;
};

/// That of the user: in $XDG_CACHE_HOME/parhelion, or else in ~/.cache/parhelion, with 1 GB or what
/// PARHELION_CACHE_SIZE says. None where this is "off" or 0, or where there is no such folder. Its program is this one
/// by its bytes: what another one has made is not taken for its own. Throws std::runtime_error for a size that is none.
std::optional<TableCache> tableCacheOfUser();

/// A store of rings that finds and keeps them there, too, if there is any cache.
RingStore ringStoreWith(std::optional<TableCache> cache);

}  // namespace parhelion
