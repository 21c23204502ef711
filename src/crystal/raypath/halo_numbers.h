// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "crystal/crystal_mesh.h"

namespace parhelion {

/// The numbers that the names of halos know the faces of a crystal by (halo_paths.h), by its own geometry: of a face
/// that lies as those of a hexagonal prism or of a pyramid of {10-11} after the crystal has been turned by `turn` (rad)
/// about c, theirs; 0 of any other. Faces of parts, caps and pits have the numbers of the faces that they are parallel
/// to.
std::vector<int> haloNumbers(const CrystalMesh& mesh, double turn);

/// By how much (rad) a crystal has to be turned about c, so that one face or another comes to lie as face 3 does, at
/// most 12 of them; turns are alike that the crystal's own symmetry makes so. No turn alone where crystals do not turn
/// freely.
std::vector<double> turnsOf(const CrystalMesh& mesh, bool turnsFreely);

}  // namespace parhelion
