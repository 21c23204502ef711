// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "crystal/crystal_mesh.h"

namespace parhelion {

/// A crystal mesh as plain numbers that lanes can run on.
struct FaceTable {
  explicit FaceTable(const CrystalMesh& mesh);

  int faces;
  int fan;                        // most triangles of a face; each face has as many places in the arrays of triangles
  std::vector<double> normal[3];  // unit, outward
  std::vector<double> offset;     // normal . point at stretch 1
  std::vector<double> area;       // at stretch 1
  std::vector<double> areaGrows;  // 1 where the area grows with the stretch, else 0
  std::vector<double> sideOne[3], sideOther[3];  // of FaceRectangle at stretch 1
  double surfaceAlongC, surfaceAcrossC;

  // Of triangle j of face i, at i * fan + j. A point of it is corner + s ab + t ac, s + t <= 1.
  std::vector<double> triangleArea;
  std::vector<double> triangleLimit;  // the same, infinite for a face's last
  std::vector<double> corner[3], ab[3], ac[3];
};

}  // namespace parhelion
