// SPDX-License-Identifier: Apache-2.0
#include "beam/pixel_directions.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "parallel/loops.h"

namespace parhelion {

namespace {

// Pixels whose corners are farther apart (rad) than this have each of their points looked up.
constexpr double kWidePixel = 0.05;

}  // namespace

PixelDirections::PixelDirections(const Camera& camera)
    : camera_(camera),
      corners_(static_cast<std::size_t>(camera.width() + 1) * static_cast<std::size_t>(camera.height() + 1)),
      middles_(static_cast<std::size_t>(camera.width()) * static_cast<std::size_t>(camera.height())),
      solidAngles_(camera.solidAngles()) {
  const auto width = static_cast<std::size_t>(camera.width()) + 1;
  forRows(camera.height() + 1, [&](int y) {
    for (std::size_t x = 0; x < width; ++x)
      corners_[static_cast<std::size_t>(y) * width + x] =
          camera.directionAt({static_cast<double>(x), static_cast<double>(y)}).value_or(Vec3(0.0));
    if (y == camera.height()) return;
    for (std::size_t x = 0; x + 1 < width; ++x)
      middles_[static_cast<std::size_t>(y) * (width - 1) + x] =
          camera.directionAt({static_cast<double>(x) + 0.5, y + 0.5}).value_or(Vec3(0.0));
  });
  for (std::size_t pixel = 0; pixel < middles_.size(); ++pixel) {
    if (solidAngles_[pixel] <= 0.0) continue;
    const bool isLit = middles_[pixel] != Vec3(0.0);
    if (isLit) largest_ = std::max(largest_, std::sqrt(solidAngles_[pixel]));
    const auto x = static_cast<int>(pixel % (width - 1)), y = static_cast<int>(pixel / (width - 1));
    hasBroken_ = hasBroken_ || !isLit || !isWhole(x, y);
  }
}

bool PixelDirections::isWhole(int x, int y) const {
  const Vec3 &a = corner(x, y), &b = corner(x + 1, y), &c = corner(x, y + 1), &d = corner(x + 1, y + 1);
  for (const Vec3* one : {&a, &b, &c, &d})
    if (*one == Vec3(0.0)) return false;
  return glm::distance(a, d) < kWidePixel && glm::distance(b, c) < kWidePixel && camera_.seam() == 0.0;
}

Vec3 PixelDirections::within(int x, int y, double u, double v) const {
  return (1.0 - v) * ((1.0 - u) * corner(x, y) + u * corner(x + 1, y)) +
         v * ((1.0 - u) * corner(x, y + 1) + u * corner(x + 1, y + 1));
}

double PixelDirections::size(int x, int y) const { return glm::distance(corner(x, y), corner(x + 1, y + 1)); }

double PixelDirections::width(int x, int y) const {
  const Vec3 &a = corner(x, y), &b = corner(x + 1, y), &c = corner(x, y + 1), &d = corner(x + 1, y + 1);
  for (const Vec3* one : {&a, &b, &c, &d})
    if (*one == Vec3(0.0)) return 0.0;
  const double longest = std::max({glm::distance(a, b), glm::distance(c, d), glm::distance(a, c), glm::distance(b, d)});
  const std::size_t pixel =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(camera_.width()) + static_cast<std::size_t>(x);
  return longest > 0.0 ? solidAngles_[pixel] / longest : 0.0;
}

}  // namespace parhelion
