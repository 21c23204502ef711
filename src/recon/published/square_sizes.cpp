// SPDX-License-Identifier: Apache-2.0
#include "recon/published/square_sizes.h"

#include "parallel/loops.h"

#include <cmath>

namespace parhelion {
namespace {

constexpr double kUnits = 1 << 20;    // of fixed point in a hit, and in a pixel's share of sky
constexpr double kRounding = 1e-5;    // relative, more than that of fixed point in the smallest squares
constexpr double kLeastShare = 0.25;  // of sky in a square that is counted upon: that of a corner

std::int64_t fixed(double value) { return static_cast<std::int64_t>(std::llround(value * kUnits)); }

/// The largest solid angle around a pixel if one of its neighbours shows no sky, as none beyond the picture does; else
/// its own.
double wholePixel(const Raster<double>& omega, const PictureShape& shape, int x, int y) {
  double largest = 0.0;
  int shown = 0;
  forColumns(y, 1, shape.height, shape.wrapY, [&](int top, int rows, int) {
    forColumns(x, 1, shape.width, shape.wrapX, [&](int left, int columns, int) {
      for (int j = top; j < top + rows; ++j) {
        for (int i = left; i < left + columns; ++i) {
          largest = std::max(largest, omega.at(i, j));
          if (omega.at(i, j) > 0.0) ++shown;
        }
      }
    });
  });
  const int around = (shape.width > 1 ? 3 : 1) * (shape.height > 1 ? 3 : 1);
  return shown == around ? omega.at(x, y) : largest;
}

}  // namespace

SkyExtent::SkyExtent(const HitMap& map)
    : shape{map.width(), map.height(), map.wrapX, map.wrapY},
      share(map.width(), map.height()),
      whole(map.width(), map.height()) {
  // A picture full of sky has whole pixels only: at the poles of a panorama, too, where they are small.
  bool full = true;
  for (std::size_t i = 0; i < map.omega.size(); ++i) full = full && map.omega[i] > 0.0;
  forRows(map.height(), [&](int y) {
    for (int x = 0; x < map.width(); ++x) {
      if (map.omega.at(x, y) <= 0.0) continue;
      whole.at(x, y) = full ? map.omega.at(x, y) : wholePixel(map.omega, shape, x, y);
      share.at(x, y) = static_cast<float>(map.omega.at(x, y) / whole.at(x, y));
    }
  });
}

Raster<int> squareSizes(const HitMap& map, const SkyExtent& sky, double samples) {
  const PictureShape& shape = sky.shape;
  const SquareSums hits(shape, [&](int x, int y) { return map.omega.at(x, y) > 0.0 ? fixed(map.hits().at(x, y)) : 0; });
  const SquareSums shown(shape, [&](int x, int y) { return fixed(static_cast<double>(sky.share.at(x, y))); });
  const auto holdsEnough = [&](int x, int y, int radius) {
    const double side = 2.0 * radius + 1.0;
    const double pixels = (shape.width > 1 ? side : 1.0) * (shape.height > 1 ? side : 1.0);
    const double showing = static_cast<double>(shown.square(x, y, radius)) / (kUnits * pixels);
    const double wanted = samples * std::max(showing, kLeastShare) * (1.0 - kRounding);
    return static_cast<double>(hits.square(x, y, radius)) >= wanted * kUnits;
  };

  const int largest = (std::max(shape.width, shape.height) - 1) / 2;
  Raster<int> radii(shape.width, shape.height);
  forRows(shape.height, [&](int y) {
    int radius = 0;
    for (int x = 0; x < shape.width; ++x) {
      if (map.omega.at(x, y) <= 0.0) continue;
      radii.at(x, y) = radius = smallestRadius(radius, largest, [&](int r) { return holdsEnough(x, y, r); });
    }
  });
  return radii;
}

}  // namespace parhelion
