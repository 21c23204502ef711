// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace parhelion {

/// Shape of an elliptic kernel of determinant 1: its covariance is [[m + p, q], [q, m - p]], m = sqrt(1 + p^2 + q^2).
/// (p, q) = (a - 1/a)/2 (cos 2t, sin 2t) for the aspect ratio a and the direction t of the long axis, from the
/// picture's x toward its y. (0, 0) is round.
struct KernelShape {
  float p = 0.0F;
  float q = 0.0F;

  /// Long over short axis, at least 1.
  float aspect() const {
    const float r2 = p * p + q * q;
    return std::sqrt(r2) + std::sqrt(1.0F + r2);
  }

  /// The shape where x is `factor` times as long as y, of the same area; no longer than the bank's longest.
  KernelShape stretched(float factor) const;
};

/// A filter of unit sum on whole cells, its rows cut to where it is not 0.
class Kernel {
 public:
  /// (1 - q/10)^3 where the quadratic form q of the inverse covariance is below 10: a smooth bump of that covariance
  /// that ends, close to a Gaussian and needing no exponential. Widths are standard deviations in cells.
  Kernel(double minor, double major, double angle);

  struct Row {
    int from;              // first column, relative to the centre
    int count;             // columns
    const float* weights;  // of these
  };

  /// Rows and columns that the kernel reaches from its centre.
  int reach() const { return std::max(rowReach_, columnReach_); }
  int columnReach() const { return columnReach_; }
  int rowReach() const { return rowReach_; }
  Row row(int dy) const {
    const Span& span = spans_[static_cast<std::size_t>(dy + rowReach_)];
    return {span.from, span.count, weights_.data() + span.first};
  }

 private:
  struct Span {
    int from, count, first;
  };
  int columnReach_ = 0, rowReach_ = 0;
  std::vector<Span> spans_;
  std::vector<float> weights_;
};

/// The kernels of a scatter pyramid, made once: short axes of 0.3 to 2 cells, aspect ratios 1 to 8.
class KernelBank {
 public:
  /// Longest reach of a kernel, cells.
  static constexpr int kMaxReach = 60;
  static constexpr float kMaxAspect = 8.0F;
  /// The quadratic form of the inverse covariance at which a kernel ends.
  static constexpr float kSupport = 10.0F;

  KernelBank();

  /// The kernel nearest to the area `variance` (product of both standard deviations, cells^2) and the shape, less
  /// `blur` (cells^2) in every direction that other steps of the filter add.
  const Kernel& nearest(float variance, KernelShape shape, float blur) const;

 private:
  static constexpr int kWidths = 24;   // widths, in equal ratios
  static constexpr int kAspects = 7;   // aspect ratios, sqrt(2) apart
  static constexpr int kAngles = 16;   // directions in half a turn
  static constexpr int kSectors = 64;  // of the table from direction to nearest angle

  int angleIndex(KernelShape shape) const;

  std::vector<Kernel> kernels_;
  std::array<int, kSectors> angleOfSector_{};
};

/// The one bank of the process.
const KernelBank& kernelBank();

/// log2 within 0.01 by plain arithmetic, the same on every machine.
float roughLog2(float x);

}  // namespace parhelion
