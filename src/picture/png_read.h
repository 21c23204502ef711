// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "picture/stored_picture.h"

namespace parhelion {

/// Reads a PNG of any kind as RGB, or RGBA where it has alpha or a transparent colour: 16 bits if it has them, else 8.
/// Text chunks go into `text`, but for what is larger than limits.h has it. Throws std::runtime_error "path: reason"
/// for whatever is wrong with it. Before it takes memory for the samples, and for the caller's `bytesForUse` a pixel,
/// it asks requireMemoryFor().
StoredPicture readPng(const std::filesystem::path& path, int bytesForUse = 0);

/// The same without the samples: only of which kind they are.
StoredPicture readPngFrame(const std::filesystem::path& path);

/// The text chunks that it has before its pixels. Throws as readPng does if it is damaged so early.
std::map<std::string, std::string> readPngText(const std::filesystem::path& path);

}  // namespace parhelion
