// SPDX-License-Identifier: Apache-2.0
#include "recon/adaptive/sky_pyramid.h"

#include "parallel/loops.h"
#include "recon/adaptive/halving.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace parhelion {
namespace {

/// Chessboard distance to the nearest cell without sky, in two passes, and to the poles.
Raster<std::uint8_t> borderDistance(const Raster<float>& omega, const std::vector<int>& poles, int pixelsPerCell) {
  const int width = omega.width(), height = omega.height();
  Raster<std::uint8_t> distance(width, height);
  const auto at = [&](int x, int y) {
    return x < 0 || y < 0 || x >= width || y >= height ? 0 : static_cast<int>(distance.at(x, y));
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (omega.at(x, y) <= 0.0F) continue;
      const int nearest = std::min({at(x - 1, y), at(x - 1, y - 1), at(x, y - 1), at(x + 1, y - 1)});
      distance.at(x, y) = static_cast<std::uint8_t>(std::min(nearest + 1, 255));
    }
  }
  for (int y = height - 1; y >= 0; --y) {
    for (int x = width - 1; x >= 0; --x) {
      const int nearest = std::min({at(x + 1, y), at(x + 1, y + 1), at(x, y + 1), at(x - 1, y + 1)});
      distance.at(x, y) = static_cast<std::uint8_t>(std::min(at(x, y), nearest + 1));
    }
  }
  for (int y = 0; y < height; ++y) {
    for (const int pole : poles) {
      const double rows = std::abs(y + 0.5 - static_cast<double>(pole) / pixelsPerCell);
      const auto fromPole = static_cast<std::uint8_t>(std::min(rows + 2.0, 255.0));
      for (int x = 0; x < width; ++x) distance.at(x, y) = std::min(distance.at(x, y), fromPole);
    }
  }
  return distance;
}

/// Means over cells of 2 x 2; what the cells at the right and lower border lack counts as 0.
Raster<float> meansOfFour(const Raster<float>& fine) {
  Raster<float> means =
      gathered<float>(fine.width(), fine.height(), [&](float& cell, int x, int y) { cell += fine.at(x, y); });
  for (float& mean : means) mean *= 0.25F;
  return means;
}

/// At the border the value of the largest neighbour, elsewhere the pixel's own.
Raster<float> filledUp(const Raster<float>& omega, const Raster<std::uint8_t>& border) {
  Raster<float> whole = omega;
  forRows(omega.height(), [&](int y) {
    for (int x = 0; x < omega.width(); ++x) {
      if (border.at(x, y) != 1) continue;
      for (int ny = std::max(y - 1, 0); ny < std::min(y + 2, omega.height()); ++ny) {
        for (int nx = std::max(x - 1, 0); nx < std::min(x + 2, omega.width()); ++nx)
          whole.at(x, y) = std::max(whole.at(x, y), omega.at(nx, ny));
      }
    }
  });
  return whole;
}

}  // namespace

SkyPyramid::SkyPyramid(int width, int height, const std::vector<double>& solidAngles, SkyFrame frame)
    : frame_(std::move(frame)) {
  double sum = 0.0;
  for (const double omega : solidAngles) {
    if (omega <= 0.0) continue;
    sum += omega;
    ++skyPixels_;
  }
  if (skyPixels_ > 0) meanSolidAngle_ = sum / static_cast<double>(skyPixels_);

  Raster<float> omega(width, height);
  for (std::size_t i = 0; i < omega.size(); ++i) {
    if (solidAngles[i] > 0.0) omega[i] = static_cast<float>(solidAngles[i] / meanSolidAngle_);
  }
  Raster<std::uint8_t> border = borderDistance(omega, frame_.poles, 1);
  wholeOmega_ = filledUp(omega, border);
  Raster<float> coverage(width, height);
  for (std::size_t i = 0; i < omega.size(); ++i) {
    if (omega[i] > 0.0F) coverage[i] = 1.0F;
  }
  levels_.push_back({std::move(omega), std::move(coverage), std::move(border)});
  while (levels_.back().omega.size() > 1) {
    omega = meansOfFour(levels_.back().omega);
    border = borderDistance(omega, frame_.poles, 1 << levels_.size());
    levels_.push_back({std::move(omega), meansOfFour(levels_.back().coverage), std::move(border)});
  }
}

SkyPyramid SkyPyramid::halved() const {
  SkyPyramid half;
  half.levels_.assign(levels_.begin() + (levels_.size() > 1 ? 1 : 0), levels_.end());
  const SkyLevel& cells = half.levels_[0];
  half.wholeOmega_ = filledUp(cells.omega, cells.border);
  for (std::size_t i = 0; i < cells.omega.size(); ++i) half.skyPixels_ += cells.omega[i] > 0.0F ? 1 : 0;
  const std::vector<float>& rows = frame_.stretch;
  for (std::size_t y = 0; y < rows.size(); y += 2)
    half.frame_.stretch.push_back(0.5F * (rows[y] + rows[std::min(y + 1, rows.size() - 1)]));
  half.frame_.bandColumns = frame_.bandColumns / 2;
  half.frame_.bandRows = frame_.bandRows / 2;
  half.meanSolidAngle_ = levels_.size() > 1 ? 4.0 * meanSolidAngle_ : meanSolidAngle_;
  return half;
}

}  // namespace parhelion
