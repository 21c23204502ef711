// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/inline.h"
#include "math/lanes.h"

namespace parhelion {

/// Light on its way between the two ends of a prism, its height unfolded: y counts lengths of the prism from the end
/// behind it, so that it meets an end at each whole y >= 1. After K of them R^K of it is left.
///
/// Four functions of y at once, by how often the light has been reflected before, even or odd: what has arrived at a
/// side up to y, as an integral over where it started, and what has arrived at ends. Both are integrals over a window
/// of starting heights:
///
///   side_p(y) = int^y R^K [K = p mod 2] dy',   end_p(y) = int^y sum_{k < K, k = p mod 2} R^k dy',   K = floor(y')
///
/// which are linear between whole y. The mean over a straight line of y is exact.
class EndCrossings {
 public:
  using Four = Lanes<4>::Real;  // side even, side odd, end even, end odd

  /// Starts anew for a reflectance. `window`: starts are spread evenly over one whole length, so that functions are
  /// those of y less those of y - 1. Without it, ends must let light through.
  void reset(double reflectance, bool window);

  /// The mean of the four functions over y from y0 to y1, both at least 0. Of light that ends do not let through, what
  /// arrives at ends is left at 0.
  PARHELION_INLINE Four mean(double y0, double y1) {
    double low = y0 < y1 ? y0 : y1, high = y0 < y1 ? y1 : y0;
    if (repeats_ && low >= 4.0) {  // the first lengths are not like those that follow
      const double whole = 2.0 * std::floor(0.5 * low) - 2.0;
      low -= whole;
      high -= whole;
    }
    const std::size_t first = cellOf(low), last = cellOf(high);
    if (first == last) {
      const Node& node = nodes_[first];
      return node.value + (0.5 * (low + high) - static_cast<double>(first)) * node.slope;
    }
    Four mean;
    across(low, first, high, last, mean);
    return mean;
  }

  /// The mean over y from y0 to y1 of the integral from 0 of both that meet sides: how far light has come on the way,
  /// counting what ends have left of it, over its starts.
  double meanOfWay(double y0, double y1);

  double reflectance() const { return reflectance_; }

 private:
  struct Node {
    Four value{}, slope{};  // at whole y, and from there to the next
    Four integral{};        // from 0
    double twice = 0.0;     // the integral of the integral of both at sides
  };

  PARHELION_INLINE std::size_t cellOf(double y) {
    const auto cell = static_cast<std::size_t>(y);
    return cell < nodes_.size() ? cell : extend(cell);
  }

  /// Makes nodes up to that of `cell`. Where no light is left all goes on in straight lines, and the last node stands
  /// for all behind it.
  std::size_t extend(std::size_t cell);
  /// By reference: code for different registers returns vectors in different ways.
  void across(double low, std::size_t first, double high, std::size_t last, Four& mean) const;
  double wayAt(double y);
  double twiceAt(double y);

  double reflectance_ = 0.0, power_ = 1.0;
  bool window_ = false, repeats_ = false;
  Four steepness_{}, arrived_{};  // the slope of the last node without a window; what ends got of one start
  std::vector<Node> nodes_;
};

}  // namespace parhelion
