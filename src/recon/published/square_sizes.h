// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "recon/hit_map.h"
#include "recon/integral_image.h"
#include "recon/published/sinc_bank.h"

namespace parhelion {

/// Where the sky of a hit map ends.
struct SkyExtent {
  explicit SkyExtent(const HitMap& map);

  PictureShape shape;
  Raster<float> share;   // of each pixel that shows sky: 1 inside, less on the border, 0 outside
  Raster<double> whole;  // relative solid angle of each pixel of the sky, had it nothing but sky
};

/// Exact sums over squares that continue across wrapped edges.
class SquareSums {
 public:
  template <class F>
  SquareSums(const PictureShape& shape, const F& value) : shape_(shape), sums_(shape.width, shape.height, value) {}

  /// Over the pixels no farther than `radius` columns and rows from (x, y).
  std::int64_t square(int x, int y, int radius) const {
    if (!shape_.wrapX && !shape_.wrapY) return sums_.square(x, y, radius);
    std::int64_t sum = 0;
    forColumns(y, radius, shape_.height, shape_.wrapY, [&](int top, int, int dy) {
      forColumns(x, radius, shape_.width, shape_.wrapX,
                 [&](int left, int, int dx) { sum += sums_.square(left - dx, top - dy, radius); });
    });
    return sum;
  }

 private:
  PictureShape shape_;
  IntegralImage<std::int64_t> sums_;
};

/// Half the side, less half a pixel, of the smallest square around each pixel of the sky that holds `samples` hits, or
/// fewer by as much of it as shows no sky: so that sizes do not grow toward the border. At most half the picture; 0
/// outside the sky. Where the border makes more than one radius right, the one nearest to that of the pixel to the
/// left.
Raster<int> squareSizes(const HitMap& map, const SkyExtent& sky, double samples);

}  // namespace parhelion
