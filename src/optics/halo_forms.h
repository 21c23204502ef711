// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "math/conventions.h"
#include "optics/sky_line.h"

namespace parhelion {

/// A halo that is a line on the sky.
struct HaloCurve {
  std::string name;  // as observers call it, UTF-8
  std::vector<SkyLine> lines;
  Vec3 labelAt;  // a place on it where little else is
};

/// A halo that is a spot on the sky.
struct HaloPoint {
  std::string name;
  Vec3 toSky;  // unit world vector
};

struct HaloForms {
  std::vector<HaloCurve> curves;
  std::vector<HaloPoint> points;
};

/// Least deviation (rad) of light by a wedge of angle `wedge` (rad) and refractive index `index`; light must pass:
/// index sin(wedge / 2) <= 1.
double leastDeviation(double wedge, double index);

/// The halos of prisms in random orientation, plates, columns and Parry columns under a point sun at azimuth 0 and
/// `sunElevation` (rad), in ice of `index`: those that have a closed form and that this sun can make, above and below
/// the horizon. Bright edges where a halo is broad. Tape 1994; Greenler 1980; Koennen 1983.
HaloForms haloForms(double sunElevation, double index);

/// The rings of pyramids in random orientation whose faces stand at 28.0 degrees to the c axis: 9, 18, 20, 23, 24 and
/// 35 degrees.
std::vector<HaloCurve> pyramidRings(double sunElevation, double index);

}  // namespace parhelion
