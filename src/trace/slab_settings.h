// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace parhelion {

/// A layer of a cloud.
struct SlabLayer {
  std::vector<std::string> populations;  // names, of crystals and haze
  double opticalDepth = 0.0;             // vertical
};

/// A cloud as a slab: plane-parallel, horizontally even, and without an end to the sides.
struct SlabSettings {
  static constexpr int kAllOrders = std::numeric_limits<int>::max();

  /// Vertical, by the shadows of the crystals: half of what counts diffraction, too. Of layers together.
  double opticalDepth = 0.0;

  /// How often light may be scattered.
  int orders = 1;

  /// From top to bottom; none: one of all populations.
  std::vector<SlabLayer> layers = {};

  /// m above sea level, for the air below and above it; none: the crystals float around the observer.
  std::optional<double> altitude = std::nullopt;
};

}  // namespace parhelion
