// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "picture/raster.h"
#include "recon/recon_settings.h"

namespace parhelion {

/// Which pixels lie across the edges of a picture, and whether it is a signal: kernels of a picture one pixel high or
/// wide are the cut through their middle.
struct PictureShape {
  int width = 0, height = 0;
  bool wrapX = false, wrapY = false;
};

/// One kernel of the method: windowedSinc() of radius r = k Ts (pixels) on whole pixels, cut to where it is not 0. It
/// is symmetric; the rows below the centre stand for those above it.
class SincKernel {
 public:
  SincKernel(double radius, double lobes, KernelGain gain, bool oneColumn, bool oneRow);

  struct Row {
    int reach;             // columns to either side
    const float* weights;  // of the middle column; -reach to reach are valid
  };

  int reachX() const { return static_cast<int>(rows_.front().reach); }
  int reachY() const { return static_cast<int>(rows_.size()) - 1; }
  Row row(int dy) const {
    const Span& span = rows_[static_cast<std::size_t>(dy < 0 ? -dy : dy)];
    return {span.reach, weights_.data() + span.middle};
  }
  std::size_t bytes() const { return weights_.size() * sizeof(float) + rows_.size() * sizeof(Span); }

 private:
  struct Span {
    int reach;
    std::size_t middle;  // of the weights
  };
  std::vector<Span> rows_;
  std::vector<float> weights_;
};

/// The kernels of all sizes that occur in a picture, each made once. Every radius up to 32 pixels has its own; beyond,
/// there are 16 to an octave, so that they fit into memory: 5 MB for a radius of 255, 320 MB for 2047.
class SincBank {
 public:
  SincBank(const Raster<int>& radii, const PictureShape& shape, double lobes, KernelGain gain);

  const SincKernel& at(int radius) const { return kernels_[static_cast<std::size_t>(index_[step(radius)])]; }
  std::size_t bytes() const;

  /// The radius of the kernel that is used for a radius.
  static int rounded(int radius);

 private:
  static std::size_t step(int radius);

  std::vector<int> index_;  // of the kernel, by step
  std::vector<SincKernel> kernels_;
};

/// Calls f(from, count, offset) for the columns from x - reach to x + reach of a row that exist: `from` is the first
/// column, `offset` its distance from x. Once without wrapping, once more for each time the row is wrapped around.
template <class F>
void forColumns(int x, int reach, int width, bool wrap, const F& f) {
  const int turns = wrap ? reach / width + 1 : 0;
  for (int turn = -turns; turn <= turns; ++turn) {
    const int middle = x + turn * width;
    const int from = std::max(middle - reach, 0), to = std::min(middle + reach + 1, width);
    if (from < to) f(from, to - from, from - middle);
  }
}

/// The sum of products, in an order that the processor's vectors can follow.
template <class T>
T dot(const float* a, const T* b, int count) {
  constexpr int kLanes = 8;
  T lanes[kLanes] = {};
  int i = 0;
  for (; i + kLanes <= count; i += kLanes) {
    for (int lane = 0; lane < kLanes; ++lane) lanes[lane] += static_cast<T>(a[i + lane]) * b[i + lane];
  }
  T sum{};
  for (; i < count; ++i) sum += static_cast<T>(a[i]) * b[i];
  for (const T lane : lanes) sum += lane;
  return sum;
}

/// The sum of a grid's values under a kernel.
double sumUnder(const SincKernel& kernel, const Raster<float>& grid, int x, int y, const PictureShape& shape);

}  // namespace parhelion
