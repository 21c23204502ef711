// SPDX-License-Identifier: Apache-2.0
#include "recon/sky_pyramid.h"

#include <algorithm>
#include <utility>

namespace parhelion {
namespace {

/// Chessboard distance to the nearest cell without sky, in two passes.
Grid<std::uint8_t> borderDistance(const Grid<float>& omega) {
  const int width = omega.width(), height = omega.height();
  Grid<std::uint8_t> distance(width, height);
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
  return distance;
}

Grid<float> halved(const Grid<float>& fine) {
  Grid<float> coarse((fine.width() + 1) / 2, (fine.height() + 1) / 2);
  forRows(coarse.height(), [&](int y) {
    for (int x = 0; x < coarse.width(); ++x) {
      const int x1 = 2 * x + 1, y1 = 2 * y + 1;
      float sum = fine.at(2 * x, 2 * y);
      if (x1 < fine.width()) sum += fine.at(x1, 2 * y);
      if (y1 < fine.height()) sum += fine.at(2 * x, y1);
      if (x1 < fine.width() && y1 < fine.height()) sum += fine.at(x1, y1);
      coarse.at(x, y) = 0.25F * sum;
    }
  });
  return coarse;
}

/// At the border the value of the largest neighbour, elsewhere the pixel's own.
Grid<float> filledUp(const Grid<float>& omega, const Grid<std::uint8_t>& border) {
  Grid<float> whole = omega;
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

SkyPyramid::SkyPyramid(int width, int height, const std::vector<double>& solidAngles) {
  double sum = 0.0;
  for (const double omega : solidAngles) {
    if (omega <= 0.0) continue;
    sum += omega;
    ++skyPixels_;
  }
  if (skyPixels_ > 0) meanSolidAngle_ = sum / static_cast<double>(skyPixels_);

  Grid<float> omega(width, height);
  for (std::size_t i = 0; i < omega.size(); ++i) {
    if (solidAngles[i] > 0.0) omega[i] = static_cast<float>(solidAngles[i] / meanSolidAngle_);
  }
  Grid<std::uint8_t> border = borderDistance(omega);
  wholeOmega_ = filledUp(omega, border);
  Grid<float> coverage(width, height);
  for (std::size_t i = 0; i < omega.size(); ++i) {
    if (omega[i] > 0.0F) coverage[i] = 1.0F;
  }
  levels_.push_back({std::move(omega), std::move(coverage), std::move(border)});
  while (levels_.back().omega.size() > 1) {
    omega = halved(levels_.back().omega);
    border = borderDistance(omega);
    levels_.push_back({std::move(omega), halved(levels_.back().coverage), std::move(border)});
  }
}

}  // namespace parhelion
