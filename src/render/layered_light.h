// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "math/portable.h"
#include "picture/image.h"
#include "render/by_elevation.h"
#include "render/crystal_sides.h"
#include "scene/scene.h"
#include "sky/camera.h"
#include "trace/phase_function.h"
#include "trace/slab_stack.h"

namespace parhelion {

/// (1 - exp(-x)) / x for x >= 0: what gets through on average from all places on a way of that depth.
inline double meanThrough(double x) { return x < 1e-5 ? 1.0 - 0.5 * x : (1.0 - portable::exp(-x)) / x; }

/// What a cloud of several layers makes of the light of single crystals, which was scattered once (slab_light.h).
/// Sunlight gets to a layer through those above; what a layer sends down goes through those below it, and what it sends
/// up through those above it.
class LayeredLight {
 public:
  /// `stack` must outlive it; `all` is the extinction of all of the scene's crystals and haze.
  LayeredLight(const SlabStack& stack, const Extinction& all, const Scene& scene);

  /// Depth that sunlight meets in all layers.
  double fromSun() const;

  /// Turns a picture of single crystals in 1/sr, per unit of the light that all of them intercept, into one of the
  /// cloud in cd/m^2. It has a layer for each population of crystals, by its name. Haze is added to the picture and to
  /// its layer for the rest, if it has one. Throws std::runtime_error when there are no such layers.
  void apply(Image& image, const Camera& camera) const;

 private:
  struct Layer {
    const SlabStack::Layer* contents;
    double depth;       // per zenith shadow
    double fromSun;     // depth that sunlight meets in it
    double fromSunTop;  // and above it
    ByElevation light;  // lightOf(); empty where azimuths matter
  };
  double toObserver(const Layer& layer, const Vec3& toSky) const;
  double lightOf(std::size_t layer, const Vec3& toSky) const;
  double at(std::size_t layer, const Vec3& toSky) const;
  double hazeAt(const Vec3& toSky) const;

  double illuminance_;
  double shadow_;  // of all crystals in sunlight, in units of the surface of a weight of 1
  Vec3 toSun_;
  CrystalSides sides_;
  std::vector<Layer> layers_;
  std::vector<std::string> populations_;
  std::vector<PhaseFunction> phases_;
  std::vector<double> hazes_;  // shadows, in the same units
};

}  // namespace parhelion
