// SPDX-License-Identifier: Apache-2.0
#pragma once

// Radial skies about one sun, and pictures to spread them over.

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "math/rotation.h"
#include "sky/camera.h"
#include "sky/radial_sky.h"
#include "sky/tally.h"

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

/// Checks that a sky of one radiance gives every pixel light by its solid angle.
inline void checkEvenRadialSky(const TallyInfo& i) {
  RadialSky sky(i, kSun, 1);
  for (int bin = 0; bin < sky.bins(); ++bin) sky.add(bin, Vec3(1000.0 * sky.solidAngle(bin)), false);
  const Tally tally = spread(sky, i);
  const std::vector<double> solidAngles = Camera(i.camera).solidAngles();
  for (int p = 0; p < tally.pixels(); ++p)
    CHECK(std::abs(tally.luminance(p) - 1000.0 * solidAngles[static_cast<std::size_t>(p)]) < 1e-5);
}

}  // namespace parhelion
