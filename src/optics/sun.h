// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "math/tabulated_density.h"
#include "optics/light_settings.h"

namespace parhelion {

/// Brightness of the sun's disc relative to its centre, at `r` from the centre as a share of the disc's radius, [0, 1].
/// Fifth-order law at 560 nm, Neckel & Labs 1994, used at every wavelength.
double limbDarkening(double r);

/// Where on the sun a ray comes from: every point of the disc in proportion to its brightness.
class Sun {
 public:
  explicit Sun(const SunSettings& settings);

  /// Unit world vector toward the sun's centre.
  const Vec3& toCentre() const { return toCentre_; }

  /// Angle across the disc, rad; 0 for a point sun.
  double diameter() const { return 2.0 * angularRadius_; }

  /// True when the sun has no extent; then directions cost no random numbers.
  bool isPoint() const { return !radius_; }

  /// Unit world vector toward a point of the disc, for two numbers in (0, 1).
  Vec3 toPoint(double u1, double u2) const;

  /// Radiance of the disc at `angle` (rad) from its centre per unit of its whole light, 1/sr; 0 outside. A point sun
  /// has none: its radiance is not finite.
  double radiance(double angle) const;

 private:
  Vec3 toCentre_;
  Mat3 frame_;
  double angularRadius_, sinRadius_;
  std::optional<TabulatedDensity> radius_;  // of r / disc radius
};

}  // namespace parhelion
