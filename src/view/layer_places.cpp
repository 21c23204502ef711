// SPDX-License-Identifier: Apache-2.0
#include "view/layer_places.h"

#include <algorithm>
#include <stdexcept>

#include "picture/colour_space.h"

namespace parhelion {

namespace {

constexpr int kSquares = 100;       // along the shorter side
constexpr double kStandsOut = 2.0;  // to the mean of the layer

}  // namespace

std::optional<Vec2> brightestPlace(const Image& image, const std::string& layer, const Camera& camera,
                                   bool belowHorizon) {
  const std::vector<float>* colours[3] = {image.find(layer + ".R"), image.find(layer + ".G"), image.find(layer + ".B")};
  for (const auto* colour : colours)
    if (!colour) throw std::invalid_argument("the picture has no layer '" + layer + "'");
  const int side = std::max(1, std::min(image.width, image.height) / kSquares);
  double brightest = 0.0, sum = 0.0;
  int squares = 0;
  Vec2 place(0.0);
  for (int top = 0; top + side <= image.height; top += side)
    for (int left = 0; left + side <= image.width; left += side) {
      const Vec2 middle = Vec2(left, top) + Vec2(0.5 * side);
      const auto toSky = camera.toSky(middle);
      if (!toSky || (!belowHorizon && toSky->z < 0.0)) continue;
      double light = 0.0;
      for (int y = top; y < top + side; ++y)
        for (int x = left; x < left + side; ++x)
          for (int c = 0; c < 3; ++c)
            light +=
                kRec709Luminance[c] *
                static_cast<double>((*colours[c])[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                                  static_cast<std::size_t>(x)]);
      sum += light;
      ++squares;
      if (light <= brightest) continue;
      brightest = light;
      place = middle;
    }
  if (!(brightest > 0.0 && brightest * squares >= kStandsOut * sum)) return std::nullopt;
  return place;
}

}  // namespace parhelion
