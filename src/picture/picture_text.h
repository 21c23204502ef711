// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace parhelion {

/// What a picture says of itself, without its pixels, which may be damaged: text attributes of an EXR, text chunks that
/// a PNG has before its pixels, comments of a JPEG as the one text "comment", a line each. Throws std::runtime_error
/// "path: reason" where the file is none of these or cannot be read so far.
std::map<std::string, std::string> readPictureText(const std::filesystem::path& path);

}  // namespace parhelion
