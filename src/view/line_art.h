// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "picture/tone.h"
#include "picture/transaction.h"
#include "view/display.h"

namespace parhelion {

/// Lines and letters to be laid over a picture: sRGB with straight alpha, row-major quadruples of 8 bits.
struct LineArt {
  int width = 0;   // pixels
  int height = 0;  // pixels
  std::vector<std::uint8_t> rgba;
};

/// Lays lines and letters over a picture: a mixture of the encoded values in proportion to alpha, as picture editors do
/// it. Throws std::invalid_argument if the sizes differ.
void layOver(Preview& picture, const LineArt& lines);
void layOver(Display& picture, const LineArt& lines);

/// Writes them as PNG with alpha, see writePhotograph.
void writeLineArt(const Output& output, const LineArt& lines, const std::map<std::string, std::string>& text);

}  // namespace parhelion
