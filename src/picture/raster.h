// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace parhelion {

/// A value for each pixel of a picture, or for each cell of a coarser one; row-major from the top left.
template <class T>
class Raster {
 public:
  Raster() = default;
  Raster(int width, int height, const T& value = T{})
      : width_(width),
        height_(height),
        values_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), value) {}

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t size() const { return values_.size(); }
  bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
  }

  T* row(int y) { return values_.data() + index(0, y); }
  const T* row(int y) const { return values_.data() + index(0, y); }
  T& at(int x, int y) { return values_[index(x, y)]; }
  const T& at(int x, int y) const { return values_[index(x, y)]; }
  /// The nearest pixel's value for places outside.
  const T& nearest(int x, int y) const { return at(std::clamp(x, 0, width_ - 1), std::clamp(y, 0, height_ - 1)); }
  T& operator[](std::size_t i) { return values_[i]; }
  const T& operator[](std::size_t i) const { return values_[i]; }
  auto begin() { return values_.begin(); }
  auto end() { return values_.end(); }
  auto begin() const { return values_.begin(); }
  auto end() const { return values_.end(); }

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<T> values_;
};

/// 1 where there is something (sky, mostly), 0 elsewhere.
using Region = Raster<std::uint8_t>;

}  // namespace parhelion
