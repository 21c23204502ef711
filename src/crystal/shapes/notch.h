// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crystal/crystal_mesh.h"

namespace parhelion {

/// A notch in each side of a prism, along all of its length, which leaves six branches: a sector plate. Seen along c it
/// is a triangle whose mouth is in the middle of the side and whose tip points to the axis.
struct Notch {
  double depth = 0.0;  // as a share of the way from the side to the axis; 0: none; below 1
  double width = 0.5;  // of its mouth, as a share of the side; below 1

  bool isThere() const { return depth > 0.0; }
  bool operator==(const Notch&) const = default;
};

/// A hexagonal prism as hexagonalPrism() makes it, with notches. Their walls are faces 73-78 and 83-88: of the notch in
/// side 3-8 that before its tip and that behind it, counter-clockwise seen from above. Where width and depth are equal
/// the walls are parallel to prism faces.
CrystalMesh notchedPrism(double aspect, const Notch& notch);

}  // namespace parhelion
