// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace parhelion {

/// A cloud as a slab: plane-parallel, horizontally even, and without an end to the sides.
struct SlabSettings {
  /// Vertical, by the shadows of the crystals: half of what counts diffraction, too.
  double opticalDepth = 0.0;
};

}  // namespace parhelion
