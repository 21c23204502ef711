// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "air/many_scatterings.h"

namespace parhelion {

inline constexpr double kEyeHeight = 0.002;  // km, of an observer above the ground

/// The air and the ground as an observer sees them, without the sun's disc. Light scattered once is integrated along
/// lines of sight through spherical shells; what is scattered more often is approximated (many_scatterings.h).
///
/// Everything but the phase functions changes slowly over the sky, and is kept in a table of directions. The phase
/// functions come to it at each place that is asked for, so that the bright sky around the sun is not smoothed.
class AirSky {
 public:
  /// For an observer at `altitude` (km) whose eyes are 2 m above it, and a sun at an elevation (rad). All processors
  /// that the caller has work on it; the bits are the same for any number. `bands` must outlive it. `cloud` is the
  /// altitude (km) of a cloud in the air, which this class does not show; none: it is where the observer is.
  AirSky(const SkySettings& settings, double altitude, double sunElevation, const LightBands& bands = sunBands(),
         std::optional<double> cloud = std::nullopt);

  /// Radiance toward a unit world vector. The sun's azimuth is +x. CIE XYZ with Y in cd/m^2, for sunBands().
  Vec3 radiance(const Vec3& toSky) const;

  /// What of it comes from the air before the cloud; 0 where the cloud is all around.
  Vec3 radianceBeforeCloud(const Vec3& toSky) const;

  /// Sunlight that arrives at the cloud, square to it, of the part of the disc above its horizon: XYZ with Y in lux.
  Vec3 sunlightAtCloud() const { return atCloud_; }

  /// What the air before the cloud leaves of that light on its way from the cloud to the observer, along an elevation
  /// (rad).
  Vec3 throughAir(double elevation) const;

  /// The sun's light as it comes through the air at an elevation (rad), as if all of the disc stood there: XYZ, Y in
  /// lux. 0 below the horizon.
  Vec3 sunlightFrom(double elevation) const;

  /// Sunlight that arrives at the observer, square to it, of the part of the disc above the horizon: XYZ with Y in lux.
  Vec3 sunlight() const { return sunlight_; }

  /// Sine of the elevation at which a cloud below the observer ends, as the earth is round; else 0.
  double cloudEdge() const;

  /// Elevation of the horizon, rad.
  double horizon() const { return horizon_; }

 private:
  /// What the phase functions multiply, and what is the same whatever the angle from the sun.
  struct Light {
    Vec3 rayleigh{0.0}, aerosol{0.0};
    Vec3 again{0.0};  // by aerosols, of light that others of them have sent on nearly forwards
    Vec3 even{0.0};
  };
  struct Air;
  static Light mix(const Light& a, const Light& b, double t);

  /// By elevation and azimuth, above the horizon and below it.
  struct Table {
    std::vector<Light> above, below;
  };
  void fill(Table& table, const Air& air, bool beforeCloud) const;
  void fill(std::vector<Light>& half, bool isAbove, const Air& air, bool beforeCloud) const;
  Light alongRay(const ViewRay& ray, const Air& air, double sine, double cosine, double end) const;
  Light between(const std::vector<Light>& table, int rows, double row, double azimuth) const;
  Vec3 radiance(const Table& table, const Vec3& toSky) const;
  double distanceToCloud(const RayPlace& from) const;

  Atmosphere air_;
  const LightBands& bands_;
  AirSpectrum plain_;
  RayPlace eye_;
  double g_, restG_;  // of aerosols' phase function; without what goes on nearly forwards
  double horizon_;
  Vec3 toSun_;
  std::optional<double> cloud_;  // altitude, km
  Table all_, before_;           // the latter empty where the cloud is all around
  Vec3 sunlight_{0.0}, atCloud_{0.0};
  Spectral sunAtCloud_{};
};

}  // namespace parhelion
