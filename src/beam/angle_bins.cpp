// SPDX-License-Identifier: Apache-2.0
#include "beam/angle_bins.h"

#include "beam/triangle_steps.h"

namespace parhelion {

PARHELION_ALSO_AVX2 void AngleBins::addTriangle(const double* angle, const double* density, const Tristimulus& xyz) {
  double place[3], light[3];
  for (int k = 0; k < 3; ++k) {
    place[k] = (angle[k] - from_) * perBin_;
    light[k] = density[k];
  }
  const Four sums = sumsOf(xyz);
  shareOut(
      place, light, size(), [&](double bin, double part) __attribute__((always_inline)) {
        light_[static_cast<std::size_t>(bin)] += part * sums;
      });
}

}  // namespace parhelion
