// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>

#include "sky/camera.h"

namespace parhelion {

/// The directions of the corners and centres of an equirectangular picture's pixels. Longitude and latitude each hold
/// for a whole column or row, so that their sines and cosines are taken once and not for every pixel.
class PanoramaGrid {
 public:
  explicit PanoramaGrid(const Camera& camera);

  /// Camera::toSky() at half of these coordinates, which must lie within the picture, but for rounding.
  std::optional<Vec3> toSky(int twiceX, int twiceY) const {
    const Line &column = columns_[static_cast<std::size_t>(twiceX)], &row = rows_[static_cast<std::size_t>(twiceY)];
    if (!column.showsSky || !row.showsSky) return std::nullopt;
    return row.cosine * column.along + row.along;
  }

  /// How the solid angle per area of the picture changes with y there: relative change per pixel.
  double slopeAt(const Vec3& toSky) const {
    const double sine = glm::dot(toSky, up_);
    return sine / (focal_ * std::sqrt(std::max(kLeast, 1.0 - sine * sine)));
  }

 private:
  /// Of a row: the cosine of its latitude, and its sine times the direction of the picture's pole. Of a column: the
  /// direction of its longitude.
  struct Line {
    bool showsSky;
    double cosine;
    Vec3 along;
  };

  static constexpr double kLeast = 1e-15;  // square of a cosine: less is rounding

  std::vector<Line> columns_, rows_;
  Vec3 up_;       // world; of the picture's upper pole
  double focal_;  // pixels
};

}  // namespace parhelion
