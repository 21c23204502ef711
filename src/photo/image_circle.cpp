// SPDX-License-Identifier: Apache-2.0
#include "photo/image_circle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace parhelion {

namespace {

constexpr double kBlack = 0.003;  // of the picture's mean: sensor noise and stray light
constexpr int kSoftRim = 2;       // pixels of the circle's rim that are mixed with black

Raster<float> brightest(const Image& linear) {
  const auto planes = linear.rgb();
  Raster<float> light(linear.width, linear.height);
  for (std::size_t i = 0; i < light.size(); ++i)
    light[i] = std::max({(*planes[0])[i], (*planes[1])[i], (*planes[2])[i]});
  return light;
}

Region widened(const Region& region) {
  Region wide = region;
  for (int y = 0; y < region.height(); ++y) {
    for (int x = 0; x < region.width(); ++x) {
      for (int dy = -kSoftRim; dy <= kSoftRim && wide.at(x, y) == 0; ++dy) {
        for (int dx = -kSoftRim; dx <= kSoftRim; ++dx) wide.at(x, y) |= region.nearest(x + dx, y + dy);
      }
    }
  }
  return wide;
}

}  // namespace

std::optional<Region> outsideImageCircle(const Image& linear) {
  const Raster<float> light = brightest(linear);
  double sum = 0.0;
  for (const float l : light) sum += std::isfinite(l) ? static_cast<double>(l) : 0.0;
  const auto black = static_cast<float>(std::max(kBlack * sum / static_cast<double>(light.size()), 0.0));
  const int right = light.width() - 1, bottom = light.height() - 1;
  std::vector<std::array<int, 2>> walk{{0, 0}, {right, 0}, {0, bottom}, {right, bottom}};
  Region outside(light.width(), light.height());
  for (const auto& [x, y] : walk) {
    if (!(light.at(x, y) <= black)) return std::nullopt;
    outside.at(x, y) = 1;
  }
  for (std::size_t i = 0; i < walk.size(); ++i) {
    for (const auto& [dx, dy] : {std::array{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
      const int x = walk[i][0] + dx, y = walk[i][1] + dy;
      if (!outside.inside(x, y) || outside.at(x, y) != 0 || !(light.at(x, y) <= black)) continue;
      outside.at(x, y) = 1;
      walk.push_back({x, y});
    }
  }
  if (walk.size() >= light.size()) return std::nullopt;
  return widened(outside);
}

Image filledFromInside(const Image& linear, const Region& outside) {
  Image filled = linear;
  const double centreX = 0.5 * linear.width, centreY = 0.5 * linear.height;
  for (int y = 0; y < linear.height; ++y) {
    for (int x = 0; x < linear.width; ++x) {
      if (outside.at(x, y) == 0) continue;
      const double dx = centreX - x, dy = centreY - y, length = std::max({std::abs(dx), std::abs(dy), 1.0});
      for (double step = 1.0; step < length; step += 1.0) {
        const int i = static_cast<int>(x + dx * step / length), j = static_cast<int>(y + dy * step / length);
        if (outside.at(i, j) != 0) continue;
        for (std::size_t c = 0; c < filled.channels.size(); ++c) {
          filled.channels[c].samples[outside.index(x, y)] = linear.channels[c].samples[outside.index(i, j)];
        }
        break;
      }
    }
  }
  return filled;
}

}  // namespace parhelion
