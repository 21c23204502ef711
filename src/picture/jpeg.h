// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "picture/stored_picture.h"
#include "picture/transaction.h"

namespace parhelion {

/// Reads a JPEG of 8 bits, grey or colour, baseline or progressive, as RGB. Bytes that do not belong there before a
/// marker are passed over, as many photographs have them. Throws std::runtime_error "path: reason" for anything else
/// that is wrong with it.
/// Before it takes memory for the samples, and for the caller's `bytesForUse` a pixel, it asks requireMemoryFor().
StoredPicture readJpeg(const std::filesystem::path& path, int bytesForUse = 0);

/// The same without the samples.
StoredPicture readJpegFrame(const std::filesystem::path& path);

/// Its comments, a line each. Nothing where it is damaged before them. Throws std::runtime_error "path: reason" where
/// the file cannot be read.
std::string readJpegComments(const std::filesystem::path& path);

/// Writes 8-bit sRGB triples, row-major, as a baseline JPEG: quality 95, no chroma subsampling, an ICC profile of sRGB,
/// and the comment unless it is empty. In one piece or not at all. Throws std::runtime_error "path: reason".
void writeJpeg(const Output& output, int width, int height, const std::vector<std::uint8_t>& rgb,
               std::string_view comment);

}  // namespace parhelion
