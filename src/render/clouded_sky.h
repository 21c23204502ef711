// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "air/air_sky.h"
#include "render/by_elevation.h"
#include "render/slab_light.h"
#include "scene/scene.h"

namespace parhelion {

/// Light that goes through a level cloud or comes back from it, of light that falls on it from one direction; both add
/// up to 1.
struct CloudFlux {
  double through;  // the direct light included
  double back;
};

/// Of a cloud of that vertical depth toward light at `rise`, the sine of its elevation, that absorbs nothing:
/// delta-Eddington (Joseph, Wiscombe & Weinman 1976, J. Atmos. Sci. 33, 2452), as Meador & Weaver 1980 write it. `g` is
/// the mean cosine of the angle of scattering.
CloudFlux cloudFlux(double depth, double rise, double g);

/// The sky and the ground of clear air, seen through a scene's cloud and lit through it. What the cloud takes from a
/// line of sight it replaces: by the mean light of the half of the sky behind it, as far as that goes through, and of
/// the half before it, as far as that comes back. Where the cloud has an altitude, there is air before it.
class CloudedSky {
 public:
  /// All must outlive it. A scene that does not say how deep its cloud is has a clear sky.
  CloudedSky(const AirSky& clear, const SlabLight& slab, const Scene& scene);

  /// Radiance toward a unit world vector; XYZ with Y in cd/m^2.
  Vec3 radiance(const Vec3& toSky) const;

  /// Whether the scene's crystals are seen in a direction.
  bool showsCrystals(const Vec3& toSky) const {
    return sides_.has(toSky) && (sides_.above || toSky.z < clear_.cloudEdge());
  }

  /// What is left of sunlight that the cloud sends here from there; XYZ, of light that is clear_.sunlightAtCloud().
  Vec3 fromCloud(const Vec3& toSky) const {
    return fromCloud_.isEmpty() ? clear_.sunlightAtCloud() : fromCloud_.at(toSky);
  }

 private:
  double directThrough(const Vec3& toSky) const;
  double through(const Vec3& toSky) const;

  const AirSky& clear_;
  const SlabLight& slab_;
  bool isClear_;
  CrystalSides sides_;
  double g_ = 0.0;
  ByElevation direct_, all_;           // shares; empty where azimuths matter
  NumberByElevation<Vec3> fromCloud_;  // empty where there is no air before it
  Vec3 above_{0.0}, below_{0.0};       // mean radiance, that of the ground as it is lit under the cloud
  Vec3 groundLeft_{1.0};               // of its clear radiance, and of that of the air under the cloud
};

}  // namespace parhelion
