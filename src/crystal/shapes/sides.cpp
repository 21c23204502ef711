// SPDX-License-Identifier: Apache-2.0
#include "crystal/shapes/sides.h"

#include <cmath>

#include "math/portable.h"

namespace parhelion {

std::vector<FacePlane> sidePlanes(const Sides& sides, int firstNumber, double slope, double z) {
  const double apothem = 0.5 * std::sqrt(3.0);
  // Opposite faces have opposite normals to the last bit.
  const double cosine[] = {1.0, 0.5, -0.5, -1.0, -0.5, 0.5}, sine[] = {0.0, apothem, apothem, 0.0, -apothem, -apothem};
  const double level = slope == 0.0 ? 1.0 : portable::cos(slope), up = slope == 0.0 ? 0.0 : portable::sin(slope);
  std::vector<FacePlane> planes;
  for (int k = 0; k < 6; ++k)
    planes.push_back(
        {firstNumber + k, Vec3(level * cosine[k], level * sine[k], up), level * apothem * sides[k] + up * z});
  return planes;
}

std::vector<FacePlane> endPlanes(double upper, double lower) {
  return {{1, Vec3(0.0, 0.0, 1.0), upper}, {2, Vec3(0.0, 0.0, -1.0), -lower}};
}

}  // namespace parhelion
