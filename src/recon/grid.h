// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>

namespace parhelion {

/// Values on the pixels of a picture, or on the cells of a coarser one; row-major from the top left.
template <class T>
class Grid {
 public:
  Grid() = default;
  Grid(int width, int height, const T& value = T{})
      : width_(width), height_(height), values_(static_cast<std::size_t>(width) * height, value) {}

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t size() const { return values_.size(); }

  T* row(int y) { return values_.data() + static_cast<std::size_t>(y) * width_; }
  const T* row(int y) const { return values_.data() + static_cast<std::size_t>(y) * width_; }
  T& at(int x, int y) { return row(y)[x]; }
  const T& at(int x, int y) const { return row(y)[x]; }
  T& operator[](std::size_t i) { return values_[i]; }
  const T& operator[](std::size_t i) const { return values_[i]; }

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<T> values_;
};

/// Calls f(y) for y = 0 ... height - 1 in parallel. What f writes must depend on y alone, so that the bits are the
/// same for any number of threads.
template <class F>
void forRows(int height, const F& f) {
  tbb::parallel_for(tbb::blocked_range<int>(0, height, 8), [&](const auto& rows) {
    for (int y = rows.begin(); y != rows.end(); ++y) f(y);
  });
}

/// The sum of f(y), a number or a vector, over all rows: rows in parallel, the sum itself in their order.
template <class F>
auto sumOverRows(int height, const F& f) {
  std::vector<decltype(f(0))> sums(static_cast<std::size_t>(height));
  forRows(height, [&](int y) { sums[static_cast<std::size_t>(y)] = f(y); });
  decltype(f(0)) total{};
  for (const auto& sum : sums) total += sum;
  return total;
}

}  // namespace parhelion
