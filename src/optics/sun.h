// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "math/tabulated_density.h"
#include "math/turn.h"
#include "optics/light_settings.h"

namespace parhelion {

/// Brightness of the sun's disc relative to its centre, at `r` from the centre as a share of the disc's radius, [0, 1].
/// Fifth-order law at 560 nm, Neckel & Labs 1994, used at every wavelength.
double limbDarkening(double r);

/// A sun with a disc, as plain numbers that lanes can run on.
struct SunDisc {
  TableQuantile radius;  // of r / disc radius
  double sinRadius;
  Triple<double> x, y, toCentre;  // a frame around the sun's centre

  /// Unit world vector toward a point of the disc, for two numbers in (0, 1).
  template <class T>
  PARHELION_INLINE Triple<T> toPoint(const T& u1, const T& u2) const {
    // The disc is flat: r is the sine of the angle from the centre over the sine of the angular radius.
    const T sinAngle = radius.at(u1) * sinRadius;
    const SineCosine<T> turn = sincosOfTurnOf(u2);
    const T a = sinAngle * turn.cos, b = sinAngle * turn.sin, c = squareRoot(1.0 - sinAngle * sinAngle);
    return {a * x.x + b * y.x + c * toCentre.x, a * x.y + b * y.y + c * toCentre.y, a * x.z + b * y.z + c * toCentre.z};
  }
};

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

  /// What the points of the disc are drawn from; of a sun that has one, and valid as long as this.
  SunDisc disc() const;

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
