// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <map>

namespace parhelion {

/// Adds up what files will take on their disks, before they are written.
class SpaceNeeds {
 public:
  /// One more file of at least so many bytes, which need not exist yet. Throws std::runtime_error "path: needs about
  /// 12 MB, 3.1 MB are free there" where ulimit -f or the disk has less. Disks that do not tell are taken to be large.
  void add(const std::filesystem::path& file, std::uint64_t bytes);

 private:
  std::map<dev_t, std::uint64_t> bytes_;
};

}  // namespace parhelion
