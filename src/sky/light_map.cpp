// SPDX-License-Identifier: Apache-2.0
#include "sky/light_map.h"

#include <algorithm>
#include <cmath>

#include "math/rotation.h"

namespace parhelion {

double MapGrid::azimuth(int column) const { return (column - binsPerHalfTurn_) * (kPi / binsPerHalfTurn_); }

double MapGrid::elevation(int row) const { return (row - binsPerHalfTurn_ / 2) * (kPi / binsPerHalfTurn_); }

int MapGrid::binAt(const Vec3& toSky) const {
  const SkyPoint sky = skyPoint(toSky);
  const double perRadian = binsPerHalfTurn_ / kPi;
  const int column = static_cast<int>(std::floor(sky.azimuth * perRadian + 0.5)) + binsPerHalfTurn_;
  const int row = static_cast<int>(std::floor(sky.elevation * perRadian + 0.5)) + binsPerHalfTurn_ / 2;
  return bin(column % columns(), std::clamp(row, 0, rows() - 1));
}

}  // namespace parhelion
