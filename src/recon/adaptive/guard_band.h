// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "recon/adaptive/sky_pyramid.h"
#include "sky/camera_settings.h"

namespace parhelion {

/// A picture with a band of the sky that adjoins its edges, for kernels that reach beyond them. Only an equirectangular
/// picture of a full turn has one: to its left what its right edge shows, and beyond the poles, where it reaches them,
/// the other side of the sky. All others are left as they are. Rows and columns count from the band's top left.
class GuardBand {
 public:
  explicit GuardBand(const CameraSettings& camera);

  int width() const { return picture_.width + 2 * columns_; }
  int height() const { return picture_.height + 2 * rows_; }

  /// Row-major index of the picture's pixel that is seen at a cell.
  std::size_t pixelAt(int x, int y) const;

  /// Row-major index of the cell at which a pixel of the picture lies.
  std::size_t cellOf(std::size_t pixel) const;

  /// How the sky lies in the picture with its band.
  SkyFrame frame() const;

 private:
  CameraSettings picture_;
  int columns_ = 0, rows_ = 0;  // of the band, on each side
};

}  // namespace parhelion
