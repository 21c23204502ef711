// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "beam/ice_light.h"
#include "beam/prism_light.h"
#include "beam/prism_section.h"
#include "beam/wanted_paths.h"

namespace parhelion {

/// A prism of one length, and its share of all crystals' surface.
struct PrismShare {
  double length, share;

  bool operator==(const PrismShare&) const = default;
};

/// Randomly oriented prisms of one cross-section, and the light that they are in.
struct ScatterScene {
  PrismSection section;
  std::vector<PrismShare> prisms;  // shares add up to 1
  IceLight light;
  /// By what paths light counts, as told for crystals whose upper end it meets; of several, each for as many crystals.
  /// None: all light.
  std::vector<WantedPaths> wanted = {};
};

/// Sums over directions, in the units of mean shadows times solid angle.
struct ScatterTotals {
  double intercepted = 0.0, external = 0.0, undeviated = 0.0, cosine = 0.0, path = 0.0, cutOff = 0.0;
  double out = 0.0;  // all that leaves and is wanted
  std::array<double, PrismLight::kOrdersTold> byOrder{};

  void add(const ScatterTotals& other, double factor);
};

}  // namespace parhelion
