// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crystal/crystal_mesh.h"

namespace parhelion {

/// The area of the shadow that a crystal of any form casts on a plane across light of that direction (unit, crystal
/// frame), crystal units squared. By the lengths of lines across the shadow: exact but for rounding where the crystal
/// is convex, right to 1e-3 where it is not.
double silhouetteOf(const CrystalMesh& mesh, const Vec3& lightDir);

}  // namespace parhelion
