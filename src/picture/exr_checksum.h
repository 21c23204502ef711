// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ImfHeader.h>

#include <filesystem>
#include <string>

#include "picture/exr.h"

namespace parhelion {

/// The checksum of all that a picture of ours says, 16 hexadecimal digits: its attributes (picture/meaning.h), and then
/// a line each, as docs/outputs.md has them, for its windows, its chromaticities, `envmap`, and each channel with the
/// checksum of its samples.
std::string pictureChecksum(const Imf::Header& header, const ExrAttributes& attributes, const Image& image);

/// Throws std::runtime_error "path: reason" if a picture carries a checksum that is not its own.
void requireUnchanged(const std::filesystem::path& path, const Imf::Header& header, const ExrAttributes& attributes,
                      const Image& image);

}  // namespace parhelion
