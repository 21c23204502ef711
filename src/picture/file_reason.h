// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

namespace parhelion {

/// "the folder halos does not exist" or "halos is no folder", for the first on the way to a file; empty where the
/// file's folder is there.
std::string missingFolderOf(const std::filesystem::path& path);

/// Why a file could not be opened, read or written: a missing folder, or what errno means.
std::string reasonFor(const std::filesystem::path& path, int error);

}  // namespace parhelion
