// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ImfHeader.h>
#include <ImfMultiPartInputFile.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "picture/image.h"

namespace parhelion {

/// The checksums of the samples of all channels, by their names.
using ChannelChecksums = std::map<std::string, std::uint64_t>;

ChannelChecksums checksumsOf(const Image& image);

/// The checksum of all that a picture of ours says, 16 hexadecimal digits: its attributes (picture/meaning.h), and then
/// a line each, as docs/outputs.md has them, for its windows, its chromaticities, `envmap` and its channels.
std::string pictureChecksum(const Imf::Header& header, const ChannelChecksums& channels);

/// Throws std::runtime_error "path: reason" if a picture carries a checksum that is not its own. It is read for that
/// from its first row to its last, in memory for a few rows.
void requireUnchanged(const std::filesystem::path& path, Imf::MultiPartInputFile& file);

}  // namespace parhelion
