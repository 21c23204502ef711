// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "air/light_bands.h"

namespace parhelion {

/// A line of sight through the air in steps: what light that is scattered in each of them brings to its beginning.
class ViewRay {
 public:
  /// From a place to space or the ground, in so many steps that are shorter near the beginning.
  ViewRay(const Atmosphere& air, const AirSpectrum& spectrum, const RayPlace& from, int steps);

  struct Step {
    double distance;  // km, of its middle
    double altitude;  // km
    double from, to;  // km, of its ends
    // Of light of unit radiance that comes from all around, or of unit irradiance times the phase function: what is
    // scattered here toward the ray's beginning and arrives there.
    Spectral rayleigh, aerosol;
  };

  const std::vector<Step>& steps() const { return steps_; }
  bool meetsGround() const { return groundDistance_ >= 0.0; }
  double groundDistance() const { return groundDistance_; }  // km

  /// Share of light from the ray's end that arrives at its beginning.
  const Spectral& transmittance() const { return transmittance_; }

 private:
  std::vector<Step> steps_;
  double groundDistance_;
  Spectral transmittance_;
};

}  // namespace parhelion
