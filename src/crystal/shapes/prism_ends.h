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

/// A plate on an end of a prism: a prism that stands like it, on the same axis.
struct Cap {
  double width = 0.0;   // of its hexagon, over the prism's; 0: none
  double aspect = 0.1;  // its own thickness over twice its own hexagon's side

  bool isThere() const { return width > 0.0; }
  bool operator==(const Cap&) const = default;
};

/// What an end of a prism has: a pit, a cap or neither.
struct PrismEnd {
  Cavity cavity = {};
  Cap cap = {};

  bool isThere() const { return cavity.isThere() || cap.isThere(); }
  bool operator==(const PrismEnd&) const = default;
};

/// A hexagonal prism as hexagonalPrism() makes it, with pits in its ends or caps on them. Of the upper end, the faces
/// of a pit are 33-38, each on the side of prism face 3-8; those of a cap are 1 on top, 53-58 around, and 52 beneath
/// where it is wider than the prism; 51 is what it leaves of the prism's own end. Those of the lower end are 43-48, 2,
/// 63-68, 61 and 62. A cap as wide as the prism has its faces 3-8. Throws std::invalid_argument where pits meet, and
/// where an end has a pit and a cap.
CrystalMesh prismWithEnds(double aspect, const PrismEnd& upper, const PrismEnd& lower);

}  // namespace parhelion
