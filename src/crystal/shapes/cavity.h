// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crystal/crystal_mesh.h"

namespace parhelion {

/// A pit in an end of a prism: a hexagonal pyramid whose apex lies on the axis.
struct Cavity {
  double depth = 0.0;  // as a share of half the prism's length; 0: none
  double width = 0.8;  // of its rim, as a share of the prism's hexagon; below 1

  bool isThere() const { return depth > 0.0; }
  bool operator==(const Cavity&) const = default;
};

/// A hexagonal prism as hexagonalPrism() makes it, with pits in its ends. The faces of the upper one are 33-38, of the
/// lower one 43-48, each on the side of prism face 3-8. Throws std::invalid_argument where pits meet.
CrystalMesh hollowPrism(double aspect, const Cavity& upper, const Cavity& lower);

}  // namespace parhelion
