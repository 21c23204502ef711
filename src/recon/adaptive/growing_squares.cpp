// SPDX-License-Identifier: Apache-2.0
#include "recon/adaptive/growing_squares.h"

#include "parallel/loops.h"
#include "recon/integral_image.h"

namespace parhelion {

Raster<float> growingSquares(const SkyPyramid& sky, const Raster<std::int64_t>& light, std::int64_t enough) {
  const int width = sky.width(), height = sky.height();
  const IntegralImage<std::int64_t> lightIn(width, height, [&](int x, int y) { return light.at(x, y); });
  const IntegralImage<double> omegaIn(width, height, [&](int x, int y) { return sky.pixels().omega.at(x, y); });

  const int largest = std::max(width, height);
  Raster<float> density(width, height);
  forRows(height, [&](int y) {
    int radius = 0;  // of the pixel before: a good first guess, the result does not depend on it
    for (int x = 0; x < width; ++x) {
      if (sky.pixels().omega.at(x, y) <= 0.0F) continue;
      radius = smallestRadius(radius, largest, [&](int r) { return lightIn.square(x, y, r) >= enough; });
      density.at(x, y) =
          static_cast<float>(static_cast<double>(lightIn.square(x, y, radius)) / omegaIn.square(x, y, radius));
    }
  });
  return density;
}

}  // namespace parhelion
