// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace parhelion {

/// Whether what a picture says of itself (readPictureText) shows that parhelion has written it.
bool saysParhelion(const std::map<std::string, std::string>& text);

/// Whether parhelion has written the file, whole or damaged: a picture, sky, map or tally. Its beginning is read only.
bool isOwnPicture(const std::filesystem::path& path);

}  // namespace parhelion
