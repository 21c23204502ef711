// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "air/light_bands.h"

namespace parhelion {

/// A place between the ground and the air's top, with the sine of the sun's elevation there: where a table for all
/// altitudes and suns is looked up.
struct SunPlace {
  SunPlace(double altitudeHere, double sunSine);

  double altitude;      // km
  double share;         // of the sun's disc above the horizon
  double sine;          // of the sun's elevation
  double aboveHorizon;  // from 0 at the horizon to 1 at the zenith; 0 below
};

/// Air masses between every altitude and the sun at every elevation, from a table.
class SunMasses {
 public:
  explicit SunMasses(const Atmosphere& air);

  OfAir at(const SunPlace& place) const;

 private:
  std::vector<OfAir> table_;  // by altitude and elevation
};

}  // namespace parhelion
