// SPDX-License-Identifier: Apache-2.0
#include "recon/adaptive/guard_band.h"

#include <algorithm>
#include <cmath>

#include "math/portable.h"
#include "sky/full_turn.h"

namespace parhelion {

GuardBand::GuardBand(const CameraSettings& camera) : picture_(camera) {
  if (!isFullTurn(camera)) return;
  // Wider than all but the widest kernels; these find nearly even sky, or nothing. Even, as cells of 2 x 2 are.
  constexpr int kShare = 8;
  columns_ = camera.width / (2 * kShare) * 2;
  if (reachesPoles(camera)) rows_ = camera.height / (2 * kShare) * 2;
}

SkyFrame GuardBand::frame() const {
  SkyFrame frame{{}, {}, columns_, rows_};
  if (!isPanorama(picture_.projection)) return frame;
  if (rows_ > 0) frame.poles = {rows_, rows_ + picture_.height};
  const double perPixel = radiansPerPixel(picture_);
  for (int y = 0; y < height(); ++y) {
    const double latitude = perPixel * (y - rows_ + 0.5 - 0.5 * picture_.height);
    // A pixel at the pole is still a finite circle.
    const double cosine = std::max(std::abs(portable::cos(latitude)), 0.25 * perPixel);
    frame.stretch.push_back(static_cast<float>(1.0 / cosine));
  }
  return frame;
}

std::size_t GuardBand::pixelAt(int x, int y) const {
  int column = x - columns_, row = y - rows_;
  if (row < 0 || row >= picture_.height) {
    row = row < 0 ? -1 - row : 2 * picture_.height - 1 - row;
    column += picture_.width / 2;
  }
  column = (column + picture_.width) % picture_.width;
  return static_cast<std::size_t>(row) * picture_.width + column;
}

std::size_t GuardBand::cellOf(std::size_t pixel) const {
  const std::size_t w = static_cast<std::size_t>(picture_.width);
  return (pixel / w + rows_) * width() + pixel % w + columns_;
}

}  // namespace parhelion
