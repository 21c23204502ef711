// SPDX-License-Identifier: Apache-2.0
#include "view/line_art.h"

#include <stdexcept>

#include "picture/photograph.h"

namespace parhelion {

namespace {

void requireSizeOf(int width, int height, const LineArt& lines) {
  if (width != lines.width || height != lines.height)
    throw std::invalid_argument("lines must have the size of the picture it is laid over");
}

}  // namespace

void layOver(Preview& picture, const LineArt& lines) {
  requireSizeOf(picture.width, picture.height, lines);
  const std::size_t pixels = lines.rgba.size() / 4;
  for (std::size_t i = 0; i < pixels; ++i) {
    const int alpha = lines.rgba[4 * i + 3];
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint8_t& below = picture.rgb[3 * i + c];
      const int mixed = alpha * lines.rgba[4 * i + c] + (255 - alpha) * below;
      below = static_cast<std::uint8_t>((mixed + 127) / 255);
    }
  }
}

void layOver(Display& picture, const LineArt& lines) {
  requireSizeOf(picture.width, picture.height, lines);
  constexpr float kWhole = 255.0F;
  for (std::size_t i = 0; i < picture.pixels(); ++i) {
    const float alpha = static_cast<float>(lines.rgba[4 * i + 3]) / kWhole;
    for (std::size_t c = 0; c < 3; ++c) {
      float& below = picture.planes[c][i];
      below += alpha * (static_cast<float>(lines.rgba[4 * i + c]) / kWhole - below);
    }
  }
}

void writeLineArt(const Output& output, const LineArt& lines, const std::map<std::string, std::string>& text) {
  Photograph picture;
  picture.width = lines.width;
  picture.height = lines.height;
  picture.channels = 4;
  picture.samples = lines.rgba;
  writePhotograph(output, picture, text);
}

}  // namespace parhelion
