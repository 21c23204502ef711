// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "beam/sun_points.h"

namespace parhelion {

/// A sun's disc by lines across it, from its lowest to its highest point: each is everywhere the same share of the way
/// from one end of a horizontal cut to the other.
class SunSlices {
 public:
  /// A disc has `cells` + 1 elevations and `lines` - 1 lines; a point has one of each.
  SunSlices(const SunFace& sun, int cells, int lines);

  /// Rad, rising.
  const std::vector<double>& elevations() const { return elevations_; }

  struct Point {
    double azimuth;  // rad, from world +x toward +y
    double weight;   // their mean by the trapezoidal rule is 1
  };
  struct Line {
    std::vector<Point> points;  // by elevation
    double share;               // of the light; all shares add up to 1
    double coarse;              // the same among half as many lines, which each second is one of; 0 for the others
  };
  const std::vector<Line>& lines() const { return lines_; }

 private:
  std::vector<double> elevations_;
  std::vector<Line> lines_;
};

}  // namespace parhelion
