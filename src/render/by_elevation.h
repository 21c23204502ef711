// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/arctangent.h"
#include "math/rotation.h"
#include "sky/camera.h"
#include "sky/pixel_mean.h"

namespace parhelion {

/// Light along the horizon has gone through a cloud without end: the sine of the elevation is never taken for less.
inline constexpr double kLevelRise = 1e-6;

/// A number, or several, by the elevation of a direction, above the horizon and below it: a table, closer toward the
/// horizon.
template <class Number>
class NumberByElevation {
 public:
  NumberByElevation() = default;
  template <class F>
  explicit NumberByElevation(const F& ofDirection) {
    for (const double side : {1.0, -1.0})
      for (std::size_t k = 0; k <= kNodes; ++k) {
        const double place = static_cast<double>(k) / static_cast<double>(kNodes),
                     elevation = 0.5 * kPi * place * place;
        numbers_.push_back(ofDirection(skyDirection(0.0, side * std::max(elevation, kLevelRise))));
      }
  }

  bool isEmpty() const { return numbers_.empty(); }

  Number at(const Vec3& toSky) const {
    const double place =
        kNodes *
        std::sqrt(std::abs(arctangent(toSky.z, std::sqrt(toSky.x * toSky.x + toSky.y * toSky.y))) / (0.5 * kPi));
    const auto node = std::min(static_cast<std::size_t>(place), kNodes - 1);
    const Number* const at = &numbers_[(toSky.z > 0.0 ? 0 : kNodes + 1) + node];
    return at[0] + (place - static_cast<double>(node)) * (at[1] - at[0]);
  }

 private:
  static constexpr std::size_t kNodes = 4096;
  std::vector<Number> numbers_;
};

using ByElevation = NumberByElevation<double>;

/// What a function of directions, which changes fast at the horizon alone, is in a pixel's middle, or, near the
/// horizon, on average over the pixel. A number that T{} is the zero of.
template <class F>
auto meanOverSlabPixel(const Camera& camera, int x, int y, const F& f) {
  // Within this of the horizon (rad), or so many times the size that pixels have on the axis, a pixel is looked at by
  // so many points to a side.
  constexpr double kNearHorizon = 0.02, kWide = 4.0;
  constexpr int kPoints = 8;
  const auto middle = camera.toSky({x + 0.5, y + 0.5});
  if (middle && std::abs(middle->z) > std::max(kNearHorizon, kWide / camera.focalLength())) return f(*middle);
  return meanOverPixel(camera, x, y, kPoints, f);
}

}  // namespace parhelion
