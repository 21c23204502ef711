// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "parallel/loops.h"
#include "picture/raster.h"

namespace parhelion {

/// More than the side of any picture (kMaxImageSide), so that a square of this radius is all of it; pixels.
inline constexpr double kBeyondAnyPicture = 1e5;

/// Sums over squares in constant time. T is std::int64_t (exact, differences even across an overflow) or double.
template <class T>
class IntegralImage {
 public:
  /// value(x, y) is what cell (x, y) adds.
  template <class F>
  IntegralImage(int width, int height, const F& value) : sums_(width + 1, height + 1) {
    forRows(height, [&](int y) {
      T sum{};
      for (int x = 0; x < width; ++x) sums_.at(x + 1, y + 1) = (sum += static_cast<T>(value(x, y)));
    });
    for (int y = 1; y <= height; ++y) {
      for (int x = 1; x <= width; ++x) sums_.at(x, y) += sums_.at(x, y - 1);
    }
  }

  /// The sum over the cells no farther than `radius` columns and rows from (x, y), as far as they exist.
  T square(int x, int y, int radius) const {
    const int x0 = std::max(x - radius, 0), x1 = std::min(x + radius + 1, sums_.width() - 1);
    const int y0 = std::max(y - radius, 0), y1 = std::min(y + radius + 1, sums_.height() - 1);
    return (sums_.at(x1, y1) - sums_.at(x0, y1)) - (sums_.at(x1, y0) - sums_.at(x0, y0));
  }

 private:
  Raster<T> sums_;
};

/// From a first guess, the nearest radius whose square holds enough while that of the next smaller does not: 0 at
/// least, `largest` at most. `holdsEnough` says whether a radius does.
template <class F>
int smallestRadius(int guess, int largest, const F& holdsEnough) {
  int radius = guess;
  while (radius < largest && !holdsEnough(radius)) ++radius;
  while (radius > 0 && holdsEnough(radius - 1)) --radius;
  return radius;
}

}  // namespace parhelion
