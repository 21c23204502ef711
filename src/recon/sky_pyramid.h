// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "recon/grid.h"

namespace parhelion {

/// Where a picture shows sky, at one resolution. Cells of level l cover 2^l x 2^l pixels.
struct SkyLevel {
  /// Solid angle of the cell per pixel area, relative to the mean pixel that shows sky; 0 where there is no sky.
  Grid<float> omega;
  /// Share of the cell's pixels that show sky, whatever their solid angle: below 1 only at the border.
  Grid<float> coverage;
  /// Columns or rows, whichever are more, to the nearest cell without sky or outside the picture: 0 for such a cell
  /// itself, at most 255.
  Grid<std::uint8_t> border;

  int width() const { return omega.width(); }
  int height() const { return omega.height(); }
};

/// The picture's solid angles at full resolution and halved until one cell is left.
class SkyPyramid {
 public:
  /// `solidAngles` row-major, sr, 0 for pixels without sky.
  SkyPyramid(int width, int height, const std::vector<double>& solidAngles);

  int width() const { return levels_[0].width(); }
  int height() const { return levels_[0].height(); }
  int levels() const { return static_cast<int>(levels_.size()); }
  const SkyLevel& level(int l) const { return levels_[static_cast<std::size_t>(l)]; }
  const SkyLevel& pixels() const { return levels_[0]; }

  /// Relative solid angle a pixel would have if sky filled it: at the border that of its largest neighbour. Kernels go
  /// by it, for a pixel cut by the image circle is not in a thinner part of the sky.
  const Grid<float>& wholeOmega() const { return wholeOmega_; }

  /// How many pixels show sky.
  std::size_t skyPixels() const { return skyPixels_; }

  /// Mean solid angle of these, sr; 0 if there are none.
  double meanSolidAngle() const { return meanSolidAngle_; }

 private:
  std::vector<SkyLevel> levels_;
  Grid<float> wholeOmega_;
  std::size_t skyPixels_ = 0;
  double meanSolidAngle_ = 0.0;
};

}  // namespace parhelion
