// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "math/conventions.h"

namespace parhelion {

/// A sun by its disc.
struct SunFace {
  Vec3 toCentre;                             // unit, world
  double radius = 0.0;                       // rad; 0 for a point
  std::function<double(double)> brightness;  // by the angle from the centre, rad; of a sun with a disc
};

/// Points of the sun's disc of one elevation, that stand for a part of it.
struct SunRow {
  Vec3 toSun;  // one of them: unit, world
  struct Point {
    double azimuth;  // rad from that one's
    double weight;
  };
  std::vector<Point> points;
};

/// A quadrature of the disc by `count` elevations with as many points each: weights add up to 1. Exact for polynomials
/// over a disc of even brightness, up to the degree 2 * count - 1.
std::vector<SunRow> sunRows(const SunFace& sun, int count);

}  // namespace parhelion
