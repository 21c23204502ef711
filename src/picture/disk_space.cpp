// SPDX-License-Identifier: Apache-2.0
#include "picture/disk_space.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/statvfs.h>

#include <stdexcept>
#include <string>

#include "picture/memory_limit.h"
#include "picture/staged_file.h"

namespace parhelion {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file, std::uint64_t need, std::uint64_t have, const char* where) {
  throw std::runtime_error(file.string() + ": needs about " + byteText(need) + ", " + byteText(have) + " are " + where);
}

}  // namespace

void SpaceNeeds::add(const std::filesystem::path& file, std::uint64_t bytes) {
  struct stat status {};
  if (descriptorOf(file) || (::stat(file.c_str(), &status) == 0 && !S_ISREG(status.st_mode))) return;
  rlimit limit{};
  if (::getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY && bytes > limit.rlim_cur)
    refuse(file, bytes, limit.rlim_cur, "allowed by ulimit -f");
  const std::filesystem::path target = followLinks(file);
  const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : ".";
  struct statvfs disk {};
  if (::stat(folder.c_str(), &status) != 0 || ::statvfs(folder.c_str(), &disk) != 0 || disk.f_blocks == 0) return;
  std::uint64_t& all = bytes_[status.st_dev];
  all += bytes;
  const std::uint64_t free = std::uint64_t{disk.f_bavail} * disk.f_frsize;
  if (all > free) refuse(file, all, free, "free there");
}

}  // namespace parhelion
