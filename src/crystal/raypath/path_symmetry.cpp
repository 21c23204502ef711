// SPDX-License-Identifier: Apache-2.0
#include "crystal/raypath/path_symmetry.h"

#include "crystal/isometry.h"
#include "crystal/symmetry.h"

namespace parhelion {

std::vector<std::vector<int>> pathSymmetries(const CrystalMesh& mesh, const OrientationSettings& orientation,
                                             PathSymmetry symmetry) {
  std::vector<std::vector<int>> all;
  for (const Isometry& isometry : hexagonalGroup()) {
    if (symmetry == PathSymmetry::none && isometry != Isometry{}) continue;
    if (symmetry == PathSymmetry::orientation && !keepsOrientations(orientation, isometry)) continue;
    if (auto images = faceImages(mesh, isometry)) all.push_back(std::move(*images));
  }
  return all;
}

}  // namespace parhelion
