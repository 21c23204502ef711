// SPDX-License-Identifier: Apache-2.0
#include "beam/angle_bins.h"

#include "beam/triangle_steps.h"

namespace parhelion {

void AngleBins::addTriangle(const double* angle, const double* density) {
  double place[3], light[3];
  for (int k = 0; k < 3; ++k) {
    place[k] = (angle[k] - from_) * perBin_;
    light[k] = density[k];
  }
  shareOut(
      place, light, size(), [&](double bin, double part) __attribute__((always_inline)) {
        light_[static_cast<std::size_t>(bin)] += part;
      });
}

}  // namespace parhelion
