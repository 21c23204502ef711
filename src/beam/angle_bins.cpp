// SPDX-License-Identifier: Apache-2.0
#include "beam/angle_bins.h"

#include <algorithm>
#include <cmath>

namespace parhelion {

PARHELION_ALSO_AVX2 void AngleBins::addTriangle(const double* angle, const double* density) {
  // Corners by their place in the bins, rising.
  double place[3], light[3];
  for (int k = 0; k < 3; ++k) {
    place[k] = (angle[k] - from_) * perBin_;
    light[k] = density[k] * (1.0 / 3.0);
  }
  const auto order = [&](int a, int b) {
    if (place[b] < place[a]) {
      std::swap(place[a], place[b]);
      std::swap(light[a], light[b]);
    }
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  const double all = light[0] + light[1] + light[2];
  if (place[2] < 0.0 || place[0] > size()) return;
  const double last = size() - 1.0;
  const double first = std::floor(std::max(place[0], 0.0)), end = std::min(std::floor(place[2]), last);
  // All in one bin, and nothing beyond the first or the last.
  if (first >= end && place[0] >= first && place[2] <= end + 1.0) {
    light_[static_cast<std::size_t>(std::min(first, last))] += all;
    return;
  }
  // Light below x: a smaller triangle at the lowest corner, or all but one at the highest. Its mean density is that of
  // the corner and of the two places where x cuts the edges: a cubic of the distance from the corner.
  const double whole = place[2] - place[0], rise = place[1] - place[0], fall = place[2] - place[1];
  const double perWhole = 1.0 / whole, perRise = rise > 0.0 ? 1.0 / rise : 0.0, perFall = fall > 0.0 ? 1.0 / fall : 0.0;
  const double slope = (light[2] - light[0]) * perWhole;
  const double square0 = 3.0 * light[0] * perRise * perWhole, square2 = 3.0 * light[2] * perFall * perWhole;
  const double cube0 = ((light[1] - light[0]) * perRise + slope) * perRise * perWhole;
  const double cube2 = ((light[1] - light[2]) * perFall - slope) * perFall * perWhole;
  const auto below = [&](double x) {
    if (x <= place[0]) return 0.0;
    if (x >= place[2]) return all;
    const bool low = x < place[1];
    const double t = low ? x - place[0] : place[2] - x;
    const double part = t * t * ((low ? square0 : square2) + t * (low ? cube0 : cube2));
    return low ? part : all - part;
  };
  double before = below(first);
  for (double bin = first; bin <= end; bin += 1.0) {
    const double behind = below(bin + 1.0);
    light_[static_cast<std::size_t>(bin)] += behind - before;
    before = behind;
  }
}

}  // namespace parhelion
