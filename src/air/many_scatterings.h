// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "air/sun_masses.h"
#include "air/view_ray.h"

namespace parhelion {

/// Phase functions, 1/sr, of the cosine of the angle by which light is deflected.
double rayleighPhase(double cosine);
double aerosolPhase(double g, double cosine);

/// Light that has been scattered, or reflected by the ground, at a place: its mean radiances over the directions that
/// look up and over those that look down.
struct ScatteredLight {
  Spectral above, below;
};

/// Share of light that aerosols scatter into a direction, at a sine of elevation, which comes from the other side of
/// the horizontal. Henyey & Greenstein's phase function; the backscattered fraction of Wiscombe & Grams 1976, J. Atmos.
/// Sci. 33, 2440.
double shareFromOtherSide(double g, double sine);

/// Light scattered more than once. From the second scattering on, light is taken to come evenly from each of the two
/// hemispheres, and suns to stand at neighbouring places as high as here. Then the mean radiances at each altitude are
/// those of light scattered once and what the mean radiances at all altitudes and the bright ground send there: the
/// integral equation of Schwarzschild and Milne (Chandrasekhar 1950, Radiative Transfer, chapter I) for two streams,
/// solved on nodes of altitude. Light scattered once has its true direction. Sunlight that aerosols send on nearly
/// forwards counts as sunlight still (ForwardLight::goesOn).
class ManyScatterings {
 public:
  /// For the suns that stand over places on lines of sight of an observer for whom it stands at `sunElevation` (rad).
  ManyScatterings(const Atmosphere& air, const LightBands& bands, const SunMasses& sun, double sunElevation);

  /// For unit irradiance above the air. 1/sr.
  ScatteredLight at(const SunPlace& place) const;

  /// Irradiance of level ground by that light, over that of the sun above the air.
  Spectral onGround(double sunSine) const;

 private:
  struct Direction;
  std::vector<Direction> directionsAt(const Atmosphere& air, const RayPlace& place, double lo, double hi,
                                      int count) const;
  Spectral once(const std::vector<Direction>& directions, const RayPlace& place, double sunSine) const;
  void addRow(const std::vector<Direction>& directions, int row);
  void solve();
  double sineOfNode(int sun) const;

  const SunMasses& sun_;
  AirSpectrum plain_, sentOn_;
  double ground_;
  double firstSine_, lastSine_;     // of the suns of the table
  std::vector<Spectral> exchange_;  // by row and column: what unit light of the column brings to the row
  std::vector<Spectral> light_;  // by row and sun. Rows: light above at each altitude, below; irradiance of the ground
};

}  // namespace parhelion
