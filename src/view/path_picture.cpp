// SPDX-License-Identifier: Apache-2.0
#include "view/path_picture.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <glm/geometric.hpp>

#include "picture/colour_space.h"
#include "picture/transfer.h"
#include "view/beside.h"
#include "view/canvas.h"

namespace parhelion {

namespace {

// Hues far apart in their order, the strongest first, so that neighbours of the list are told apart; sRGB, all about as
// light.
constexpr Colour kHues[kMostHues] = {{0.90, 0.62, 0.00}, {0.34, 0.71, 0.91}, {0.00, 0.75, 0.50}, {0.95, 0.90, 0.25},
                                     {0.25, 0.45, 1.00}, {0.95, 0.37, 0.10}, {0.85, 0.50, 0.85}, {0.55, 0.85, 0.20},
                                     {1.00, 0.55, 0.60}, {0.10, 0.80, 0.80}, {0.70, 0.55, 0.35}, {0.62, 0.42, 1.00}};
constexpr Colour kOther{0.75, 0.75, 0.75};

double luminance(const Image& image, const std::string& prefix, std::size_t pixel) {
  const auto sample = [&](const char* colour) {
    const auto* samples = image.find(prefix + colour);
    if (!samples) throw std::invalid_argument("the picture has no channel " + prefix + colour);
    return static_cast<double>((*samples)[pixel]);
  };
  return glm::dot(kRec709Luminance, Vec3(sample("R"), sample("G"), sample("B")));
}

/// Hues and names, one below the other.
Preview legend(std::span<const std::string> layers, int height) {
  const double em = std::clamp(height / 32.0, 10.0, 22.0), row = 1.5 * em;
  Canvas measure(1, 1);
  double widest = 0.0;
  for (const std::string& layer : layers) widest = std::max(widest, measure.textBox(layer, em).size().x);
  const int width = static_cast<int>(std::ceil(widest + 4.0 * em));
  const int rows = static_cast<int>(std::ceil(row * (static_cast<double>(layers.size()) + 2.0)));
  Canvas canvas(width, std::max(height, rows));
  double y = row;
  const auto line = [&](const std::string& name, const Colour& hue) {
    canvas.rectangle({{em, y}, {2.2 * em, y + em}}, hue);
    canvas.text(name, {2.8 * em, y - 0.1 * em}, em, {0.9, 0.9, 0.9}, {0.0, 0.0, 0.0});
    y += row;
  };
  for (std::size_t i = 0; i < layers.size(); ++i) line(layers[i], kHues[i]);
  line("all else", kOther);
  const LineArt art = canvas.lineArt();
  Preview picture{
      art.width, art.height,
      std::vector<std::uint8_t>(3 * static_cast<std::size_t>(art.width) * static_cast<std::size_t>(art.height), 0), 0};
  layOver(picture, art);
  return picture;
}

}  // namespace

Preview paintByLayer(const Image& image, std::span<const std::string> layers, double exposureStops) {
  if (layers.size() > kMostHues) throw std::invalid_argument("more layers than there are hues");
  Preview picture = developPreview(image, {exposureStops});
  for (std::size_t i = 0; i < image.pixels(); ++i) {
    double most = luminance(image, "", i);
    for (const std::string& layer : layers) most -= luminance(image, layer + ".", i);  // what is in none of them
    Colour hue = kOther;
    for (std::size_t k = 0; k < layers.size(); ++k)
      if (const double own = luminance(image, layers[k] + ".", i); own > most) {
        most = own;
        hue = kHues[k];
      }
    // As light as the grey of the picture's pixel.
    std::uint8_t* rgb = &picture.rgb[3 * i];
    const double grey = 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
    for (const auto& [at, part] : {std::pair{0, hue.red}, std::pair{1, hue.green}, std::pair{2, hue.blue}})
      rgb[at] = static_cast<std::uint8_t>(std::lround(std::min(255.0, part * grey * 1.15)));
  }
  return beside(picture, legend(layers, image.height));
}

}  // namespace parhelion
