// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sky/camera.h"

namespace parhelion {

/// Where the pixels of a picture look, for lookups of many points in each.
class PixelDirections {
 public:
  explicit PixelDirections(const Camera& camera);

  const Camera& camera() const { return camera_; }

  /// Solid angle (sr) of a pixel; 0 where it shows no sky.
  double solidAngle(std::size_t pixel) const { return solidAngles_[pixel]; }
  const std::vector<double>& solidAngles() const { return solidAngles_; }

  /// The largest root of a pixel's solid angle, rad, of those whose middles show sky.
  double largest() const { return largest_; }

  /// Whether any pixel with sky is not whole, or its middle shows none.
  bool hasBroken() const { return hasBroken_; }

  /// The direction of a pixel's middle, or 0 where that shows no sky.
  const Vec3& middle(std::size_t pixel) const { return middles_[pixel]; }

  /// Whether all of a pixel shows sky and its corners are close together.
  bool isWhole(int x, int y) const;

  /// The direction at a place in a whole pixel, each coordinate from 0 to 1; unit to second order.
  Vec3 within(int x, int y, double u, double v) const;

  /// The angle across a pixel's diagonal, rad.
  double size(int x, int y) const;

  /// How narrow it is: its solid angle over the longest of its edges, rad. 0 where a corner sees no sky.
  double width(int x, int y) const;

 private:
  const Vec3& corner(int x, int y) const {
    return corners_[static_cast<std::size_t>(y) * static_cast<std::size_t>(camera_.width() + 1) +
                    static_cast<std::size_t>(x)];
  }

  Camera camera_;
  std::vector<Vec3> corners_, middles_;  // 0 where there is no sky
  std::vector<double> solidAngles_;
  double largest_ = 0.0;
  bool hasBroken_ = false;
};

}  // namespace parhelion
