// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the readers of single formats hand to readPhotograph.

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "picture/photograph.h"

namespace parhelion {

struct StoredPicture {
  Photograph picture;              // as stored: not turned, `exif` not read
  std::vector<std::uint8_t> exif;  // the block from its byte order mark on, or empty
  std::string objection;           // what speaks against sRGB, "its colours are ..."; empty if nothing does
};

/// "path: reason" on one line.
std::runtime_error pictureError(const std::filesystem::path& path, std::string reason);

/// Throws unless a picture has pixels, and no more of them than we accept.
void requireReadableSize(const std::filesystem::path& path, std::int64_t width, std::int64_t height);

/// Throws if a file of `have` bytes is too short for the picture it promises.
void requireFileBytes(const std::filesystem::path& path, std::uint64_t have, std::uint64_t need);

}  // namespace parhelion
