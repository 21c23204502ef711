// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "math/inline.h"

namespace parhelion {

/// Shares the light of a triangle out over steps of a line, [k, k + 1) each, from 0 to `size` - 1: across the triangle
/// both the place on the line and the density are linear. `place` and `light` are those of its corners; the mean of
/// the latter is all its light. Calls add(step, light) as a double and the light in it; what lies outside falls into
/// none. Exact.
template <class Add>
PARHELION_INLINE void shareOut(double (&place)[3], double (&light)[3], double size, const Add& add) {
  for (double& l : light) l *= 1.0 / 3.0;
  // Corners by their place, rising.
  const auto order = [&](int a, int b) __attribute__((always_inline)) {
    if (place[b] < place[a]) {
      std::swap(place[a], place[b]);
      std::swap(light[a], light[b]);
    }
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  const double all = light[0] + light[1] + light[2];
  if (place[2] < 0.0 || place[0] > size) return;
  const double last = size - 1.0;
  const double first = std::floor(std::max(place[0], 0.0)), end = std::min(std::floor(place[2]), last);
  // All in one step, and nothing beyond the first or the last.
  if (first >= end && place[0] >= first && place[2] <= end + 1.0) return add(std::min(first, last), all);
  // Light below x: a smaller triangle at the lowest corner, or all but one at the highest. Its mean density is that of
  // the corner and of the two places where x cuts the edges: a cubic of the distance from the corner.
  const double whole = place[2] - place[0], rise = place[1] - place[0], fall = place[2] - place[1];
  const double perWhole = 1.0 / whole, perRise = rise > 0.0 ? 1.0 / rise : 0.0, perFall = fall > 0.0 ? 1.0 / fall : 0.0;
  const double slope = (light[2] - light[0]) * perWhole;
  const double square0 = 3.0 * light[0] * perRise * perWhole, square2 = 3.0 * light[2] * perFall * perWhole;
  const double cube0 = ((light[1] - light[0]) * perRise + slope) * perRise * perWhole;
  const double cube2 = ((light[1] - light[2]) * perFall - slope) * perFall * perWhole;
  const auto below = [&](double x) __attribute__((always_inline)) {
    if (x <= place[0]) return 0.0;
    if (x >= place[2]) return all;
    const bool low = x < place[1];
    const double t = low ? x - place[0] : place[2] - x;
    const double part = t * t * ((low ? square0 : square2) + t * (low ? cube0 : cube2));
    return low ? part : all - part;
  };
  double before = below(first);
  for (double step = first; step <= end; step += 1.0) {
    const double behind = below(step + 1.0);
    add(step, behind - before);
    before = behind;
  }
}

}  // namespace parhelion
