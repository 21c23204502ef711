// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "picture/raster.h"

namespace parhelion {

/// Where a picture shows sky, at one resolution. Cells of level l cover 2^l x 2^l pixels.
struct SkyLevel {
  /// Solid angle of the cell per pixel area, relative to the mean pixel that shows sky; 0 where there is no sky.
  Raster<float> omega;
  /// Share of the cell's pixels that show sky, whatever their solid angle: below 1 only at the border.
  Raster<float> coverage;
  /// Columns or rows, whichever are more, to the nearest cell without sky or outside the picture: 0 for such a cell
  /// itself, at most 255. A pole lies between cells of 2: kernels that reach it see less sky on its other side than
  /// they would if the solid angle went on as it does on theirs.
  Raster<std::uint8_t> border;

  int width() const { return omega.width(); }
  int height() const { return omega.height(); }
};

/// How the sky lies in a picture.
struct SkyFrame {
  std::vector<float> stretch;  // of every row, how many times wider than high a circle in the sky is; empty if round
  std::vector<int> poles;      // rows at whose upper edge the solid angle comes to a point
  int bandColumns = 0, bandRows = 0;  // on each side, that repeat sky shown elsewhere in the picture
};

/// The picture's solid angles at full resolution and halved until one cell is left.
class SkyPyramid {
 public:
  /// `solidAngles` row-major, sr, 0 for pixels without sky.
  SkyPyramid(int width, int height, const std::vector<double>& solidAngles, SkyFrame frame = {});

  /// The same sky at half the resolution: its pixels are cells of 2 x 2. A single pixel stays as it is.
  SkyPyramid halved() const;

  int width() const { return levels_[0].width(); }
  int height() const { return levels_[0].height(); }
  int levels() const { return static_cast<int>(levels_.size()); }
  const SkyLevel& level(int l) const { return levels_[static_cast<std::size_t>(l)]; }
  const SkyLevel& pixels() const { return levels_[0]; }

  /// Relative solid angle a pixel would have if sky filled it: at the border that of its largest neighbour. Kernels go
  /// by it, for a pixel cut by the image circle is not in a thinner part of the sky.
  const Raster<float>& wholeOmega() const { return wholeOmega_; }

  /// How many times wider than high a circle in the sky is in this row.
  float stretch(int y) const { return frame_.stretch.empty() ? 1.0F : frame_.stretch[static_cast<std::size_t>(y)]; }

  /// Whether a pixel is sky that no other pixel repeats.
  bool counts(int x, int y) const {
    return pixels().omega.at(x, y) > 0.0F && x >= frame_.bandColumns && x < width() - frame_.bandColumns &&
           y >= frame_.bandRows && y < height() - frame_.bandRows;
  }

  /// How many pixels show sky.
  std::size_t skyPixels() const { return skyPixels_; }

 private:
  SkyPyramid() = default;

  std::vector<SkyLevel> levels_;
  Raster<float> wholeOmega_;
  SkyFrame frame_;
  std::size_t skyPixels_ = 0;
  // Solid angle that is relative 1, sr: the mean of these pixels' (at half resolution four times that); 0 without any.
  double meanSolidAngle_ = 0.0;
};

}  // namespace parhelion
