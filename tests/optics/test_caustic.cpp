// SPDX-License-Identifier: Apache-2.0
#include "optics/caustic.h"

#include <algorithm>
#include <array>

#include "optics/face_path.h"
#include "optics/halo_curves.h"

using namespace parhelion;

TEST_CASE("the folds of light through two sides of rolling columns are the tangent arcs") {
  const Vec3 toSun = skyDirection(0.0, radians(20));
  const AnglesToSky map = [&](double azimuth, double roll) {
    const Vec3 axis = skyDirection(azimuth, 0.0), level = glm::cross(Vec3(0.0, 0.0, 1.0), axis);
    const auto side = [&](double turn) {
      return std::cos(roll + turn) * Vec3(0.0, 0.0, 1.0) + std::sin(roll + turn) * level;
    };
    return seenOver(std::array{side(0.0), side(radians(120))}, toSun, kIndex);
  };
  const std::vector<SkyLine> folds = foldsOf(map, {0.0, 2.0 * kPi, 180}, {0.0, 2.0 * kPi, 180});
  const HaloForms forms = haloForms(radians(20), kIndex);
  std::size_t upper = 0, lower = 0;
  for (const SkyLine& line : folds)
    for (std::size_t i = 0; i < line.size(); ++i) {
      double nearest = 1.0;
      for (const char* name : {"upper tangent arc", "lower tangent arc"})
        for (const SkyLine& arc : curveAt(forms, name).lines)
          for (const Vec3& p : arc) nearest = std::min(nearest, glm::length(p - line[i]));
      ++(line[i].z > toSun.z ? upper : lower);
      // Half a step of the arc, and the sagitta of the folds' own steps of two degrees of azimuth.
      CHECK(nearest < 0.5 * kSkyLineStep + radians(0.02));
      if (i > 0) CHECK(glm::length(line[i] - line[i - 1]) <= kSkyLineStep * (1.0 + 1e-6));
    }
  CHECK(upper > 200);
  CHECK(lower > 30);
}

TEST_CASE("a map that folds nowhere has no folds") {
  CHECK(foldsOf([](double azimuth, double elevation) { return skyDirection(azimuth, elevation); }, {-1.0, 1.0, 40},
                {-1.0, 1.0, 40})
            .empty());
}
