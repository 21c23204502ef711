// SPDX-License-Identifier: Apache-2.0
#include "view/layer.h"

#include <stdexcept>

#include "image/photograph.h"

namespace parhelion {

void layOver(Preview& picture, const Layer& layer) {
  if (picture.width != layer.width || picture.height != layer.height)
    throw std::invalid_argument("a layer must have the size of the picture it is laid over");
  const std::size_t pixels = layer.rgba.size() / 4;
  for (std::size_t i = 0; i < pixels; ++i) {
    const int alpha = layer.rgba[4 * i + 3];
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint8_t& below = picture.rgb[3 * i + c];
      const int mixed = alpha * layer.rgba[4 * i + c] + (255 - alpha) * below;
      below = static_cast<std::uint8_t>((mixed + 127) / 255);
    }
  }
}

void writeLayer(const std::filesystem::path& path, const Layer& layer, const std::map<std::string, std::string>& text) {
  Photograph picture;
  picture.width = layer.width;
  picture.height = layer.height;
  picture.channels = 4;
  picture.samples = layer.rgba;
  writePhotograph(path, picture, text);
}

}  // namespace parhelion
