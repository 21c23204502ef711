// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "crystal/crystal_mesh.h"
#include "crystal/distributions.h"
#include "math/conventions.h"

namespace parhelion {

/// Hexagonal prism with {10-11} pyramids on its ends, cut off where they are lower than a full apex.
struct PyramidSettings {
  static constexpr std::string_view kName = "pyramid";
  double aspect = 1.0;           // of the prism part, L / 2a; 0: the two pyramids meet at the equator
  double upper = 0.5;            // height of the upper pyramid as a share of its full apex height, [0, 1]
  double lower = 0.5;            // the same below
  double slope = radians(28.0);  // angle between a pyramid face and the c axis
};

/// Hexagonal prism with pyramids on its ends, hexagon side 1 where they meet the prism. Faces 13-18 and 23-28 lie above
/// and below the prism faces 3-8; basal faces 1 and 2 exist where a pyramid is cut off, prism faces where aspect > 0.
/// Throws std::invalid_argument where lengthOverWidth() is below kThinnestAspect or above kLongestAspect.
CrystalMesh hexagonalPyramid(const PyramidSettings& settings);

/// What the aspect is for a prism, of the whole crystal: its length along c over twice the hexagon's side.
double lengthOverWidth(const PyramidSettings& settings);

inline CrystalMesh meshOf(const PyramidSettings& pyramid) { return hexagonalPyramid(pyramid); }
inline std::optional<AngleDistribution> stretchOf(const PyramidSettings&) { return std::nullopt; }
inline bool hasEndsAlike(const PyramidSettings& pyramid) { return pyramid.upper == pyramid.lower; }

}  // namespace parhelion
