// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "image/tone.h"

namespace parhelion {

/// Writes an 8-bit sRGB PNG, in one piece or not at all (atomic_file.h). `text` goes into tEXt chunks, keyword to
/// value (keywords of 1 to 79 Latin-1 characters). Throws std::runtime_error "path: reason".
void writePng(const std::filesystem::path& path, const Preview& preview,
              const std::map<std::string, std::string>& text);

}  // namespace parhelion
