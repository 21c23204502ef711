// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "picture/raster.h"

namespace parhelion {

/// Scattered hits on pixels: what the named methods work on.
struct HitMap {
  /// Light in each pixel, 0 where there is no sky. The first kind is the luminance in effective hits (scaled so that it
  /// has the variance of counts, if hits are independent); methods choose sizes, cells and the number of iterations by
  /// it. The others (a difference between halves, colour) are filtered in the same way.
  std::vector<Raster<double>> lights;
  /// Solid angle of each pixel relative to the mean pixel that shows sky; 0 where there is no sky.
  Raster<double> omega;
  /// Whether the left edge touches the right one, and the upper the lower. Pixels across such an edge are neighbours.
  bool wrapX = false, wrapY = false;

  int width() const { return omega.width(); }
  int height() const { return omega.height(); }
  const Raster<double>& hits() const { return lights.front(); }
};

/// What a method makes of a hit map.
struct Reconstruction {
  std::vector<Raster<double>> lights;  // per relative solid angle, as many as the hit map has; 0 where there is no sky
  std::vector<std::string> remarks;    // for people: that an iteration grew and was stopped, which size was chosen
};

}  // namespace parhelion
