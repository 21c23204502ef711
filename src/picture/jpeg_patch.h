// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string_view>

#include "picture/photograph.h"

namespace parhelion {

/// Writes what changed in a JPEG into a copy of it, so that the rest is not encoded anew. `original` is a file that
/// readPhotograph accepts, `changed` its picture, upright, in 8 bits, with other samples. The copy has the original's
/// markers (Exif with its orientation, profile, comments), `comment` unless it is empty or there already, quantisation
/// tables and sampling, and is progressive if that was. The transform of what changed, rounded to the tables' steps, is
/// added to the coefficients; so blocks whose own pixels (a chroma block: the pixels it is the mean of) did not change
/// keep them, and what they decode to has the same bits, but for the pixel next to a block that did change where the
/// chroma is subsampled.
///
/// Returns false, and writes nothing, where that cannot be: `original` is no JPEG, or a grey one and `changed` is not
/// grey, or JpegCoefficients finds it not repeatable. Takes the picture in 8 bits twice and its coefficients once.
/// Throws std::runtime_error "path: reason" in one line, std::invalid_argument if the pictures differ in their size or
/// `changed` has other samples than RGB in 8 bits.
[[nodiscard]] bool writePatchedJpeg(const Output& output, const std::filesystem::path& original,
                                    const Photograph& changed, std::string_view comment = {});

}  // namespace parhelion
