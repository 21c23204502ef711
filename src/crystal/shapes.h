// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crystal/crystal_mesh.h"
#include "crystal/population_settings.h"

namespace parhelion {

/// Hexagonal prism centred on the origin, hexagon side 1, length 2 * `aspect` along c. Faces 1-8.
CrystalMesh hexagonalPrism(double aspect);

/// Hexagonal prism with pyramids on its ends, hexagon side 1 where they meet the prism. Faces 13-18 and 23-28 lie above
/// and below the prism faces 3-8; basal faces 1 and 2 exist where a pyramid is cut off, prism faces where aspect > 0.
/// Throws std::invalid_argument when nothing encloses a volume.
CrystalMesh hexagonalPyramid(const PyramidSettings& settings);

}  // namespace parhelion
