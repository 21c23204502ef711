// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <variant>

#include "picture/tone.h"
#include "picture/transaction.h"

namespace parhelion {

/// Components of a picture, row-major and interleaved, as sRGB of 8 or of 16 bits.
struct PngSamples {
  int width = 0;
  int height = 0;
  int channels = 3;  // RGB, or 4 with alpha
  std::variant<std::span<const std::uint8_t>, std::span<const std::uint16_t>> samples;
};

/// Writes an sRGB PNG, in one piece or not at all (atomic_file.h). `text` goes into tEXt chunks, keyword to value
/// (keywords of 1 to 79 Latin-1 characters). Throws std::runtime_error "path: reason".
void writePng(const Output& output, const Preview& preview, const std::map<std::string, std::string>& text);

/// The same, packed in a hurry: a photograph's noise does not get much smaller with patience.
void writePng(const Output& output, const PngSamples& picture, const std::map<std::string, std::string>& text);

}  // namespace parhelion
