// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "crystal/population_settings.h"
#include "crystal/raypath/path_pattern.h"

namespace parhelion {

/// What the isometries of a symmetry do to the faces of a crystal: face i goes to face images[i]. The identity is
/// first. Crystals with a symmetry of their own that is not part of the hexagonal prism's have it ignored.
std::vector<std::vector<int>> pathSymmetries(const CrystalMesh& mesh, const OrientationSettings& orientation,
                                             PathSymmetry symmetry);

}  // namespace parhelion
