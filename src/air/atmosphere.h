// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "air/air_settings.h"

namespace parhelion {

// Lengths in this folder are in kilometres.
inline constexpr double kGroundRadius = 6371.0;  // of the earth
inline constexpr double kAirTop = 100.0;         // altitude above which there is no air
inline constexpr double kRayleighHeight = 8.0;   // in which the density of molecules falls to 1/e

/// A number for each constituent of the air.
struct OfAir {
  double rayleigh = 0.0, ozone = 0.0, aerosol = 0.0;
};

/// A place on a straight ray: its distance from the earth's centre, and the sine of the ray's elevation there.
struct RayPlace {
  double radius;  // km
  double sine;

  /// Of a ray at an altitude (km), at an elevation (rad).
  static RayPlace at(double altitude, double elevation);

  /// What it becomes after a distance (km).
  RayPlace after(double distance) const;

  double altitude() const { return radius - kGroundRadius; }

  /// Distance to an altitude (km) on the way up, at or above this place.
  double distanceUpTo(double altitude) const;

  /// Distance to an altitude (km) at or below this place on the way down, or, where the ray passes above it, to where
  /// it is lowest.
  double distanceDownTo(double altitude) const;

  /// The same ray on its way back.
  RayPlace reversed() const { return {radius, -sine}; }

  /// Distance to the ground; negative where the ray misses it.
  double distanceToGround() const;
};

/// Sine of the elevation of the horizon at a distance (km) from the earth's centre; 0 at the ground, negative above it.
double horizonSine(double radius);

/// Share of the sun's disc, of the usual size and evenly bright, above the horizon when its centre is at `above` (rad).
double shareAboveHorizon(double above);

/// The air as spherical shells, at 1013.25 hPa at sea level, without refraction. Rays are straight.
class Atmosphere {
 public:
  explicit Atmosphere(const SkySettings& settings) : settings_(settings) {}

  const SkySettings& settings() const { return settings_; }

  /// Vertical optical depths from sea level to space at a wavelength (nm), 360-830. Rayleigh: Hansen & Travis 1974,
  /// Space Sci. Rev. 16, 527, eq. 2.30, within 1 %. Ozone: absorption alone, cross sections at 233 K (optics/tables.h).
  OfAir depths(double wavelength) const;

  /// Density at an altitude (km) over that of a vertical path as a whole, 1/km. Ozone lies in a layer of triangular
  /// profile from 10 to 40 km. Below sea level as at it.
  OfAir densities(double altitude) const;

  /// Air masses on a ray to space: how many times the vertical path from sea level has the same amount. A ray that
  /// meets the ground goes on as if the air there were that of sea level.
  OfAir massesToSpace(const RayPlace& place) const;

  /// Share of light of a wavelength (nm) that comes through from space along a ray, 0 where the earth is in between.
  double transmittance(double wavelength, double altitude, double elevation) const;

  /// The same for sunlight, of whose disc the horizon hides a part as it sets. `elevation` (rad) is that of its centre.
  double sunTransmittance(double wavelength, double altitude, double elevation) const;

 private:
  SkySettings settings_;
};

}  // namespace parhelion
