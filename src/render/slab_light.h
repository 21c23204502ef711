// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "picture/image.h"
#include "render/by_elevation.h"
#include "render/crystal_sides.h"
#include "scene/scene.h"
#include "sky/camera.h"
#include "trace/slab_stack.h"

namespace parhelion {

class LayeredLight;

/// What a cloud of some depth makes of the light of single crystals, in absolute units.
///
/// Of light that was scattered once: sunlight gets to a crystal through what lies above, and the crystal's light to the
/// observer through what lies between. Above the horizon the observer sees the cloud from below, and below the horizon
/// from above. Light that passes undeviated through parallel faces goes on and is not scattered.
class SlabLight {
 public:
  /// Where that share of sunlight on crystals, haze apart, passes undeviated, as many rays have found. A scene without
  /// a cloud has so few crystals that they dim no sunlight, wherever the sun stands: an optical depth of 0.05. Throws
  /// as Extinction does.
  SlabLight(const Scene& scene, double undeviated);

  SlabLight(SlabLight&&) noexcept;
  SlabLight& operator=(SlabLight&&) noexcept;
  ~SlabLight();

  /// Of the crystals and the haze, layer by layer.
  const SlabStack& stack() const { return stack_; }

  /// Depth that light from a direction of the sky meets.
  double depthToward(const Vec3& toSky) const { return stack_.depthAlong(toSky, kLevelRise); }

  /// Whether azimuths make no difference to it.
  bool isSameAllAround() const { return extinction_.isSameAllAround(); }

  /// How much of the sunlight that the cloud meets is met by haze. 0 where there are layers, to which apply() itself
  /// adds it.
  double ofHaze() const { return ofHaze_; }

  /// Sunlight in front of the cloud on a surface that faces it, lx.
  double illuminance() const { return illuminance_; }

  /// Sunlight behind the cloud on a surface that faces it, lx: what got through without being scattered.
  double directIlluminance() const;

  /// What a radiance per unit of intercepted light (1/sr) amounts to in a direction of the sky, cd/m^2, in a cloud
  /// without layers. 0 where the sun is not above the horizon.
  double luminanceAt(const Vec3& toSky) const;

  /// Turns a picture in 1/sr into one in cd/m^2, all layers and errors with it.
  void apply(Image& image, const Camera& camera) const;

 private:
  double exactLuminanceAt(const Vec3& toSky) const;

  Extinction extinction_;
  SlabStack stack_;
  double illuminance_;
  Vec3 toSun_;
  double sunShadow_, ofHaze_;  // of crystals in sunlight, as Extinction has it
  bool isLit_;                 // whether the sun reaches it
  CrystalSides sides_;
  double fromSun_;           // depth that sunlight meets
  ByElevation byElevation_;  // luminances; empty where azimuths matter
  std::unique_ptr<const LayeredLight> layered_;
};

}  // namespace parhelion
