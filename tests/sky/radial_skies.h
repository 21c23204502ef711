// SPDX-License-Identifier: Apache-2.0
#pragma once

// Radial skies about one sun, and pictures to spread them over.

#include <cmath>

#include "math/rotation.h"
#include "sky/radial_sky.h"

namespace parhelion {

inline TallyInfo info(Projection projection, double fovDegrees, int width, int height, double elevationDegrees,
                      double circleDegrees = 0.0) {
  TallyInfo i;
  i.camera.projection = projection;
  i.camera.fieldOfView = radians(fovDegrees);
  i.camera.imageCircle = radians(circleDegrees);
  i.camera.width = width;
  i.camera.height = height;
  i.camera.elevation = radians(elevationDegrees);
  i.camera.roll = radians(5);
  i.white = {0.97, 1.0, 1.05};
  return i;
}

inline const Vec3 kSun = skyDirection(0.0, radians(20));

/// A point of the sky at an angle from the sun.
inline Vec3 atAngle(double angle) {
  const Vec3 across = glm::normalize(glm::cross(kSun, Vec3(0.3, 0.9, 0.1)));
  return std::cos(angle) * kSun + std::sin(angle) * across;
}

inline Tally spread(const RadialSky& sky, const TallyInfo& i, int colours = 1) {
  Tally tally(i, colours);
  sky.spreadOver(tally);
  return tally;
}

}  // namespace parhelion
