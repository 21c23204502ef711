// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "math/conventions.h"
#include "optics/halo_makers.h"
#include "optics/sky_line.h"

namespace parhelion {

/// A halo that is a line on the sky.
struct HaloCurve {
  std::string name;  // as observers call it, UTF-8
  HaloFamily family;
  bool isRare = false;  // faint, and missing from most displays
  std::vector<SkyLine> lines;
  Vec3 labelAt = Vec3(0.0);  // a place on it where little else is
};

/// A halo that is a spot on the sky.
struct HaloPoint {
  std::string name;
  HaloFamily family;
  Vec3 toSky;  // unit world vector
};

struct HaloForms {
  std::vector<HaloCurve> curves;  // rare ones last
  std::vector<HaloPoint> points;
};

/// Least deviation (rad) of light by a wedge of angle `wedge` (rad) and refractive index `index`; light must pass:
/// index sin(wedge / 2) <= 1.
double leastDeviation(double wedge, double index);

/// The halos of crystals under a point sun at azimuth 0 and `sunElevation` (rad), in ice of `index`: those that have a
/// name and that these crystals can make with this sun, above and below the horizon. Bright edges where a halo is
/// broad. What several kinds of crystals make belongs to the first family that does. Tape 1994; Greenler 1980; Koennen
/// 1983.
HaloForms haloForms(double sunElevation, double index, std::span<const HaloMaker> makers);

/// The same for all makers of halos.
HaloForms haloForms(double sunElevation, double index);

}  // namespace parhelion
