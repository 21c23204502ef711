// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "crystal/crystal_mesh.h"

namespace parhelion {

/// Builds a crystal from horizontal hexagons stacked along c, each possibly shrunk to a point or left out.
class HexagonStack {
 public:
  /// Adds the six corners at height z, or the apex when `side` is 0; returns the index of the first. Corner k lies
  /// between prism faces 3 + (k + 5) % 6 and 3 + k, at -30 + 60 k degrees from face 3's normal.
  int addRing(double side, double z);

  /// Six faces numbered from `firstNumber` between a lower and an upper ring.
  void addBelt(int firstNumber, int lower, bool lowerIsApex, int upper, bool upperIsApex);

  void addTop(int ring) { faces.push_back({1, {ring, ring + 1, ring + 2, ring + 3, ring + 4, ring + 5}}); }
  void addBottom(int ring) { faces.push_back({2, {ring + 5, ring + 4, ring + 3, ring + 2, ring + 1, ring}}); }

  std::vector<Vec3> vertices;
  std::vector<FaceOutline> faces;
};

}  // namespace parhelion
