// SPDX-License-Identifier: Apache-2.0
#include "picture/upright.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace parhelion {
namespace {

/// Where the pixels of the upright picture are stored: (x, y) at origin + x * stepX + y * stepY.
struct Route {
  std::ptrdiff_t origin, stepX, stepY;
};

/// `width` and `height` are those of the stored picture.
Route routeOf(int orientation, std::ptrdiff_t width, std::ptrdiff_t height) {
  const std::ptrdiff_t right = width - 1, bottom = (height - 1) * width;
  switch (orientation) {
    case 2:
      return {right, -1, width};
    case 3:
      return {bottom + right, -1, -width};
    case 4:
      return {bottom, 1, -width};
    case 5:
      return {0, width, 1};
    case 6:
      return {bottom, -width, 1};
    case 7:
      return {bottom + right, -width, -1};
    case 8:
      return {right, width, -1};
    default:
      return {0, 1, width};
  }
}

/// Goes by squares, so that columns of the one and rows of the other picture stay in the cache.
template <int kChannels, typename Sample>
std::vector<Sample> turned(const std::vector<Sample>& stored, const Route& route, int width, int height) {
  constexpr int kSquare = 32;
  std::vector<Sample> upright(stored.size());
  for (int top = 0; top < height; top += kSquare) {
    for (int left = 0; left < width; left += kSquare) {
      for (int y = top; y < std::min(top + kSquare, height); ++y) {
        Sample* to = upright.data() + (static_cast<std::ptrdiff_t>(y) * width + left) * kChannels;
        for (int x = left; x < std::min(left + kSquare, width); ++x, to += kChannels) {
          std::copy_n(stored.data() + (route.origin + x * route.stepX + y * route.stepY) * kChannels, kChannels, to);
        }
      }
    }
  }
  return upright;
}

}  // namespace

void turnUpright(Photograph& photograph, int orientation) {
  if (orientation < 2 || orientation > 8) return;
  const Route route = routeOf(orientation, photograph.width, photograph.height);
  if (orientation >= 5) std::swap(photograph.width, photograph.height);
  const int width = photograph.width, height = photograph.height;
  std::visit(
      [&](auto& samples) {
        if (samples.empty()) return;  // only what surrounds them is wanted
        samples = photograph.channels == 4 ? turned<4>(samples, route, width, height)
                                           : turned<3>(samples, route, width, height);
      },
      photograph.samples);
}

}  // namespace parhelion
