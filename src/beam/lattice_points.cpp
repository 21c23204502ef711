// SPDX-License-Identifier: Apache-2.0
#include "beam/lattice_points.h"

#include <algorithm>

#include "math/inline.h"
#include "math/lanes.h"

namespace parhelion {

namespace {

using Four = Lanes<4>::Real;

// Along one side points follow each other, along the other each is ahead by this, of the whole side. The golden ratio
// would be too near to 5/8, by which colours go.
constexpr double kStepAcross = 0.41421356237309505;

}  // namespace

LatticePoints::LatticePoints(const SpreadLight& light, double share, int count, const std::array<double, kColours>& at,
                             unsigned start)
    : turn_(kStepAcross * start), perCount_(1.0 / count), count_(count), start_(start) {
  // Values at the corners: value + s along + t across + s t both.
  const auto set = [&](int row, const double(&a)[4], const double(&b)[4], double factor) {
    for (int k = 0; k < kColours; ++k) {
      const double u = at[colourOf(k)];
      double corner[4];
      for (int n = 0; n < 4; ++n) corner[n] = factor * (a[n] + u * (b[n] - a[n]));
      coefficients_[row][k] = corner[0];
      coefficients_[row + 1][k] = corner[1] - corner[0];
      coefficients_[row + 2][k] = corner[2] - corner[0];
      coefficients_[row + 3][k] = corner[3] - corner[2] - corner[1] + corner[0];
    }
  };
  set(0, light.from.place, light.to.place, 1.0);
  set(4, light.from.density, light.to.density, share * perCount_);
}

int LatticePoints::next() {
  const int count = std::min(count_ - done_, kMost);
  if (count > 0) fill(count);
  done_ += count;
  return count;
}

PARHELION_ALSO_AVX2 void LatticePoints::fill(int count) {
  for (int k = 0; k < count; k += 4) {
    const int lane = k % kColours;
    Four s, t;
    for (int n = 0; n < 4; ++n) s[n] = done_ + k + n;
    t = turn_ + kStepAcross * s;
    t -= wholePart(t);
    s = perCount_ * (s + 0.5);
    const auto value = [&](int row) {
      const auto of = [&](int which) { return load<Four>(&coefficients_[row + which][lane]); };
      return of(0) + s * of(1) + t * (of(2) + s * of(3));
    };
    store(&place_[k], Four(value(0)));
    store(&light_[k], Four(value(4)));
  }
}

}  // namespace parhelion
