// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace parhelion {

/// A cloud as a slab: plane-parallel, horizontally even, and without an end to the sides.
struct SlabSettings {
  static constexpr int kAllOrders = std::numeric_limits<int>::max();

  /// Vertical, by the shadows of the crystals: half of what counts diffraction, too.
  double opticalDepth = 0.0;

  /// How often light may be scattered.
  int orders = 1;
};

}  // namespace parhelion
