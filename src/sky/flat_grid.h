// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "math/conventions.h"
#include "sky/camera.h"

namespace parhelion {

/// The directions of the corners and centres of the pixels of a rectilinear picture without distortion. A column and a
/// row each bring their part of a direction, which is taken once and not for every pixel.
class FlatGrid {
 public:
  explicit FlatGrid(const Camera& camera);

  /// Camera::directionAt() at half of these coordinates, to the bit, whatever the horizon. They must lie within the
  /// picture.
  Vec3 toSky(int twiceX, int twiceY) const {
    const Line &column = columns_[static_cast<std::size_t>(twiceX)], &row = rows_[static_cast<std::size_t>(twiceY)];
    const double cosine = 1.0 / std::sqrt(1.0 + (column.place * column.place + row.place * row.place));
    return cosine * (column.along + row.along) + cosine * forward_;
  }

 private:
  struct Line {
    double place;  // from the axis, focal lengths
    Vec3 along;    // so far along the picture's right or up, world
  };

  std::vector<Line> columns_, rows_;
  Vec3 forward_;  // world
};

}  // namespace parhelion
