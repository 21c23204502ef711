// SPDX-License-Identifier: Apache-2.0
#include "photo/skyline.h"

#include <algorithm>
#include <cmath>

namespace parhelion {

namespace {

constexpr int kWindow = 3;           // pixels above and below that are compared
constexpr int kHalfWidth = 2;        // pixels to the left and right that are averaged
constexpr float kStrongEdge = 8.0F;  // steps at which the small part of the edge's weight saturates
constexpr float kStrongShare = 0.2F;
constexpr float kNoSky = 1.0F;   // a column all of land
constexpr float kNoLand = 0.7F;  // a column all of sky

float saturated(float x) { return x * x / (1.0F + x * x); }

Raster<Opponent> smoothedRows(const Raster<Opponent>& colours) {
  Raster<Opponent> smooth(colours.width(), colours.height());
  for (int y = 0; y < colours.height(); ++y) {
    for (int x = 0; x < colours.width(); ++x) {
      const int left = std::max(0, x - kHalfWidth), right = std::min(colours.width() - 1, x + kHalfWidth);
      Opponent sum{};
      for (int i = left; i <= right; ++i) {
        for (std::size_t c = 0; c < 3; ++c) sum[c] += colours.at(i, y)[c];
      }
      for (float& s : sum) s /= static_cast<float>(right - left + 1);
      smooth.at(x, y) = sum;
    }
  }
  return smooth;
}

Opponent columnMean(const Raster<Opponent>& colours, int x, int top, int bottom) {
  top = std::clamp(top, 0, colours.height() - 1);
  bottom = std::clamp(bottom, top + 1, colours.height());
  Opponent sum{};
  for (int y = top; y < bottom; ++y) {
    for (std::size_t c = 0; c < 3; ++c) sum[c] += colours.at(x, y)[c];
  }
  for (float& s : sum) s /= static_cast<float>(bottom - top);
  return sum;
}

// Cost of the skyline above row s of column x, s = 0 to the height.
Raster<float> columnCosts(const Raster<float>& edges, const SkylinePrice& price) {
  const int rows = edges.height();
  Raster<float> costs(edges.width(), rows);
  for (int x = 0; x < edges.width(); ++x) {
    float passed = 0.0F;
    for (int s = 0; s < rows; ++s) {
      // An edge shows in several rows, and the skyline's own is not one it has passed.
      if (s >= kWindow) passed += price.passedEdge * edges.at(x, s - kWindow) / (kWindow + 1);
      costs.at(x, s) = s == 0 ? kNoSky : s + 1 == rows ? kNoLand + passed : 1.0F - edges.at(x, s) + passed;
    }
  }
  return costs;
}

}  // namespace

Raster<float> horizontalEdges(const SkyScene& scene) {
  const Raster<Opponent> smooth = smoothedRows(scene.colours);
  Raster<float> edges(smooth.width(), smooth.height() + 1);
  for (int y = 1; y < smooth.height(); ++y) {
    for (int x = 0; x < smooth.width(); ++x) {
      const Opponent above = columnMean(smooth, x, y - kWindow, y), below = columnMean(smooth, x, y, y + kWindow);
      const Opponent higher = columnMean(smooth, x, y - 2 * kWindow, y - kWindow);
      float square = 0.0F;
      for (std::size_t c = 0; c < 3; ++c) {
        const float change = below[c] - above[c];
        const float gradient = y >= 2 * kWindow ? above[c] - higher[c] : 0.0F;
        const float excess = std::min(std::abs(change), std::abs(change - gradient));
        square += excess * excess;
      }
      const float steps = std::sqrt(square) / scene.step;
      edges.at(x, y) = (1.0F - kStrongShare) * saturated(steps) + kStrongShare * saturated(steps / kStrongEdge);
    }
  }
  return edges;
}

Region aboveSkyline(const Raster<float>& edges, const SkylinePrice& price) {
  const int width = edges.width(), rows = edges.height();
  Raster<float> cost = columnCosts(edges, price);
  Raster<int> from(width, rows);
  for (int x = 1; x < width; ++x) {
    // The lower envelope of cones of the given slope, in two passes.
    for (int s = 0; s < rows; ++s) from.at(x, s) = s;
    const auto reach = [&](int s, int neighbour) {
      const int origin = from.at(x, neighbour);
      const auto via = [&](int o) { return cost.at(x - 1, o) + price.slope * static_cast<float>(std::abs(o - s)); };
      if (via(origin) < via(from.at(x, s))) from.at(x, s) = origin;
    };
    for (int s = 1; s < rows; ++s) reach(s, s - 1);
    for (int s = rows - 2; s >= 0; --s) reach(s, s + 1);
    for (int s = 0; s < rows; ++s) {
      const int origin = from.at(x, s);
      cost.at(x, s) += cost.at(x - 1, origin) + price.slope * static_cast<float>(std::abs(origin - s));
    }
  }
  int best = 0;
  for (int s = 1; s < rows; ++s) {
    if (cost.at(width - 1, s) < cost.at(width - 1, best)) best = s;
  }
  Region sky(width, rows - 1);
  for (int x = width - 1; x >= 0; --x) {
    for (int y = 0; y < best; ++y) sky.at(x, y) = 1;
    if (x > 0) best = from.at(x, best);
  }
  return sky;
}

}  // namespace parhelion
