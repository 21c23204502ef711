// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "image/image.h"

namespace parhelion {

/// Text attributes of a file, name to value: "software", "parhelion:version", "parhelion:seed", "parhelion:rays",
/// "parhelion:scene" and so on. Numbers are text too: EXR has no 64-bit integers.
using ExrAttributes = std::map<std::string, std::string>;

struct ExrFile {
  Image image;
  ExrAttributes attributes;
};

/// Writes a picture for any viewer: one part, all channels as 32-bit floats, scan lines, ZIP, with the chromaticities
/// of Rec.709. Adds `capDate` if the environment sets SOURCE_DATE_EPOCH; else the same picture gives the same bytes. In
/// one piece or not at all (atomic_file.h). Throws std::runtime_error "path: reason".
void writeBeautyExr(const std::filesystem::path& path, const Image& image, ExrAttributes attributes);

/// Reads the first part of any flat scan-line EXR, all channels as floats, and its text attributes. The memory it takes
/// is bounded by the size of the file. Throws std::runtime_error "path: reason" for whatever is wrong with it.
ExrFile readExr(const std::filesystem::path& path);

}  // namespace parhelion
