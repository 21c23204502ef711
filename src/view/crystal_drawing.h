// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "math/conventions.h"
#include "picture/transaction.h"

namespace parhelion {

/// A crystal in the air and light on its way through it. World frame; lengths in any unit.
struct CrystalDrawing {
  struct Face {
    int number;
    std::vector<int> vertices;  // counter-clockwise seen from outside
    Vec3 normal;                // unit, outward
  };
  struct Light {
    Vec3 from, to;
    double energy;  // share of the ray's; its line is as thick as that is much
    bool hasArrow;  // at its end
  };

  std::vector<Vec3> vertices;
  std::vector<Face> faces;
  std::vector<Light> light;
  std::string caption;  // UTF-8
};

/// Draws it from the side, with the sun at the left, and from above, as SVG: hidden edges dashed, faces numbered. In
/// one piece or not at all. Throws std::runtime_error "path: reason".
void drawCrystal(const Output& svg, const CrystalDrawing& drawing, const std::string& software);

}  // namespace parhelion
