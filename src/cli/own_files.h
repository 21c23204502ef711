// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace parhelion::cli {

/// Whether parhelion has written the file: a picture by what it says of itself, a table by its columns, JSON by its
/// keys, a chart by a comment. Nobody loses anything by an empty file either: it counts, too.
bool isOwnFile(const std::filesystem::path& path);

}  // namespace parhelion::cli
