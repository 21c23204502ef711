// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <vector>

#include "parallel/loops.h"
#include "recon/adaptive/level_kernels.h"
#include "recon/adaptive/scatter.h"

namespace parhelion {

/// Where the border takes part of what even sky would get through the kernels.
class NearBorder {
 public:
  template <std::size_t N>
  NearBorder(const Raster<Light<N>>& light, const SkyLevel& sky, const Raster<KernelSite>& sites, double hits,
             int level)
      : shares_(sky.width(), sky.height()), blocks_(blocksOf(sky.width()), blocksOf(sky.height())) {
    std::vector<int> farthest(static_cast<std::size_t>(blocks_.height()));
    forRows(blocks_.height(), [&](int by) {
      for (int y = by * kBlock; y < std::min((by + 1) * kBlock, sky.height()); ++y) {
        for (int x = 0; x < sky.width(); ++x) {
          const int border = sky.border.at(x, y);
          if (light.at(x, y)[0] == 0.0F || border == 0 || 3 * border >= 4 * (KernelBank::kMaxReach + 1)) continue;
          if (3 * border >= 4 * (mostReach(sites.at(x, y), hits, level) + 1)) continue;
          // In full where the kernel here touches the border, then fading.
          const auto reach = static_cast<float>(kernelAt(sites, x, y, hits, level).reach() + 1);
          const float share = std::clamp(4.0F - 3.0F * static_cast<float>(border) / reach, 0.0F, 1.0F);
          if (share <= 0.0F) continue;
          shares_.at(x, y) = share;
          blocks_.at(x / kBlock, by) = 1;
          farthest[static_cast<std::size_t>(by)] = std::max(farthest[static_cast<std::size_t>(by)], border);
        }
      }
    });
    farthest_ = *std::max_element(farthest.begin(), farthest.end());
    widen();
  }

  /// How much the border matters to a cell, 0 to 1; 0 where there is no light.
  float share(int x, int y) const { return shares_.at(x, y); }

  /// Whether cells to which it matters are within the longest kernel's reach of a cell, as far as blocks tell.
  bool isClose(int x, int y) const { return close_.at(x / kBlock, y / kBlock) != 0; }

  /// Whether a cell at this distance from the border could, with a kernel of this reach, reach such cells.
  bool within(int border, int reach) const { return border <= farthest_ + reach; }

  /// Whether such a cell is in a block that the kernel comes into.
  bool touchedBy(const Kernel& kernel, int x, int y) const {
    const int columns = kernel.columnReach(), rows = kernel.rowReach();
    const int left = std::max(x - columns, 0) / kBlock, right = std::min((x + columns) / kBlock, blocks_.width() - 1);
    const int top = std::max(y - rows, 0) / kBlock, bottom = std::min((y + rows) / kBlock, blocks_.height() - 1);
    for (int by = top; by <= bottom; ++by) {
      const char* row = blocks_.row(by);
      if (std::find(row + left, row + right + 1, 1) != row + right + 1) return true;
    }
    return false;
  }

 private:
  static constexpr int kBlock = 16;  // cells
  static int blocksOf(int cells) { return (cells + kBlock - 1) / kBlock; }

  void widen() {
    constexpr int kReach = KernelBank::kMaxReach / kBlock + 1;
    close_ = {blocks_.width(), blocks_.height()};
    for (int by = 0; by < blocks_.height(); ++by) {
      for (int bx = 0; bx < blocks_.width(); ++bx) {
        if (blocks_.at(bx, by) == 0) continue;
        for (int y = std::max(by - kReach, 0); y <= std::min(by + kReach, blocks_.height() - 1); ++y) {
          char* row = close_.row(y);
          std::fill(row + std::max(bx - kReach, 0), row + std::min(bx + kReach, blocks_.width() - 1) + 1, 1);
        }
      }
    }
  }

  Raster<float> shares_;
  Raster<char> blocks_;  // 1: the border matters to a cell in it
  Raster<char> close_;   // 1: such a block is within reach
  int farthest_ = 0;     // of all these from the border
};

}  // namespace parhelion
