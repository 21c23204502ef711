// SPDX-License-Identifier: Apache-2.0
#include "picture/file_reason.h"

#include <cerrno>
#include <system_error>

#include "picture/temporary_file.h"

namespace parhelion {

std::string missingFolderOf(const std::filesystem::path& path) {
  const std::filesystem::path target = followLinks(path);
  std::error_code none;
  for (std::filesystem::path folder = target.parent_path(); !folder.empty() && folder.has_relative_path();
       folder = folder.parent_path()) {
    const std::filesystem::file_status status = std::filesystem::status(folder, none);
    if (std::filesystem::is_directory(status)) break;
    const bool parentIsThere = !folder.has_parent_path() || std::filesystem::is_directory(folder.parent_path(), none);
    if (parentIsThere)
      return std::filesystem::exists(status) ? folder.string() + " is no folder"
                                             : "the folder " + folder.string() + " does not exist";
  }
  return {};
}

std::string reasonFor(const std::filesystem::path& path, int error) {
  if (error == ENOENT || error == ENOTDIR)
    if (std::string folder = missingFolderOf(path); !folder.empty()) return folder;
  if (error == EFBIG) return "the file would be larger than ulimit -f or the file system allows";
  return std::generic_category().message(error);
}

}  // namespace parhelion
