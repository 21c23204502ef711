// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/projections/orthographic.h"

namespace parhelion::projections {

/// The celestial sphere from outside and far away, as a globe on a table. Its near side faces the viewer, with the
/// optical axis in its middle; what is at an observer's right in the sky is at the left.
struct Globe : Orthographic {
  static constexpr bool showsHemispheres = true, isMirrored = true, hasDiagonal = false;
  static constexpr double defaultElevation = 0;
};

}  // namespace parhelion::projections
