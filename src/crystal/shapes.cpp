// SPDX-License-Identifier: Apache-2.0
#include "crystal/shapes.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "math/portable.h"

namespace parhelion {

namespace {

/// Builds a crystal from horizontal hexagons stacked along c, each possibly shrunk to a point or left out.
class HexagonStack {
 public:
  /// Adds the six corners at height z, or the apex when `side` is 0; returns the index of the first. Corner k lies
  /// between prism faces 3 + (k + 5) % 6 and 3 + k, at -30 + 60 k degrees from face 3's normal.
  int addRing(double side, double z) {
    const int first = static_cast<int>(vertices.size());
    if (side == 0.0) {
      vertices.emplace_back(0.0, 0.0, z);
      return first;
    }
    const double x = 0.5 * std::sqrt(3.0) * side, y = 0.5 * side;
    for (const auto& [cx, cy] :
         std::array<std::array<double, 2>, 6>{{{x, -y}, {x, y}, {0.0, side}, {-x, y}, {-x, -y}, {0.0, -side}}})
      vertices.emplace_back(cx, cy, z);
    return first;
  }

  /// Six faces numbered from `firstNumber` between a lower and an upper ring.
  void addBelt(int firstNumber, int lower, bool lowerIsApex, int upper, bool upperIsApex) {
    for (int k = 0; k < 6; ++k) {
      const int next = (k + 1) % 6;
      std::vector<int> ring{lowerIsApex ? lower : lower + k};
      if (!lowerIsApex) ring.push_back(lower + next);
      ring.push_back(upperIsApex ? upper : upper + next);
      if (!upperIsApex) ring.push_back(upper + k);
      faces.push_back({firstNumber + k, ring});
    }
  }

  void addTop(int ring) { faces.push_back({1, {ring, ring + 1, ring + 2, ring + 3, ring + 4, ring + 5}}); }
  void addBottom(int ring) { faces.push_back({2, {ring + 5, ring + 4, ring + 3, ring + 2, ring + 1, ring}}); }

  std::vector<Vec3> vertices;
  std::vector<FaceOutline> faces;
};

}  // namespace

CrystalMesh hexagonalPrism(double aspect) {
  HexagonStack stack;
  const int lower = stack.addRing(1.0, -aspect), upper = stack.addRing(1.0, aspect);
  stack.addTop(upper);
  stack.addBottom(lower);
  stack.addBelt(3, lower, false, upper, false);
  return CrystalMesh(stack.vertices, stack.faces);
}

CrystalMesh hexagonalPyramid(const PyramidSettings& settings) {
  if (settings.aspect == 0.0 && settings.upper == 0.0 && settings.lower == 0.0)
    throw std::invalid_argument("a pyramid crystal needs a prism part or a pyramid of some height");
  // The face normals of the hexagon stand at the apothem from the axis; a pyramid face climbs from there to the apex.
  const double apexHeight = 0.5 * std::sqrt(3.0) / portable::tan(settings.slope);

  HexagonStack stack;
  const int lower = stack.addRing(1.0, -settings.aspect);
  const int upper = settings.aspect > 0.0 ? stack.addRing(1.0, settings.aspect) : lower;
  if (settings.aspect > 0.0) stack.addBelt(3, lower, false, upper, false);

  int top = upper, bottom = lower;
  if (settings.upper > 0.0) {
    top = stack.addRing(1.0 - settings.upper, settings.aspect + settings.upper * apexHeight);
    stack.addBelt(13, upper, false, top, settings.upper == 1.0);
  }
  if (settings.lower > 0.0) {
    bottom = stack.addRing(1.0 - settings.lower, -settings.aspect - settings.lower * apexHeight);
    stack.addBelt(23, bottom, settings.lower == 1.0, lower, false);
  }
  if (settings.upper < 1.0) stack.addTop(top);
  if (settings.lower < 1.0) stack.addBottom(bottom);
  return CrystalMesh(stack.vertices, stack.faces);
}

}  // namespace parhelion
