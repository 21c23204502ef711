// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "crystal/crystal_mesh.h"
#include "crystal/distributions.h"
#include "crystal/shape_spread.h"
#include "crystal/shapes/sides.h"
#include "math/conventions.h"

namespace parhelion {

/// Hexagonal prism with pyramids on its ends, {10-11} unless said otherwise, cut off where they are lower than a full
/// apex. With sides that are not regular, the full apex is still that of the regular crystal, and each pyramid face
/// meets the prism face of its side at the height where the prism ends.
struct PyramidSettings {
  static constexpr std::string_view kName = "pyramid";
  double aspect = 1.0;           // of the prism part, L / 2a; 0: the two pyramids meet at the equator
  double upper = 0.5;            // height of the upper pyramid as a share of its full apex height, [0, 1]
  double lower = 0.5;            // the same below
  double slope = radians(28.0);  // angle between a pyramid face and the c axis
  std::optional<double> upperSlope = std::nullopt, lowerSlope = std::nullopt;  // where an end has its own
  Sides sides = kRegularSides;
  std::vector<ShapeSpread> spreads = {};
};

/// The slope (rad) of the pyramid faces with Miller indices {h 0 -h l} of ice, by the ratio of its axes
/// c/a = 1.6288: 27.999 degrees for {1 0 -1 1}, 14.888 for {2 0 -2 1}.
double slopeOfMiller(int h, int l);

/// The crystal of such settings with regular sides: hexagon side 1 where the pyramids meet the prism. Faces 13-18 and
/// 23-28 lie above and below the prism faces 3-8; basal faces 1 and 2 exist where a pyramid is cut off, prism faces
/// where aspect > 0. Throws std::invalid_argument where lengthOverWidth() is below kThinnestAspect or above
/// kLongestAspect.
CrystalMesh hexagonalPyramid(const PyramidSettings& settings);

/// What the aspect is for a prism, of the whole crystal: its length along c over twice the hexagon's side.
double lengthOverWidth(const PyramidSettings& settings);

CrystalMesh meshOf(const PyramidSettings& pyramid);
inline std::optional<AngleDistribution> stretchOf(const PyramidSettings&) { return std::nullopt; }
inline bool hasEndsAlike(const PyramidSettings& p) {
  return p.upper == p.lower && p.upperSlope.value_or(p.slope) == p.lowerSlope.value_or(p.slope);
}
inline bool isHexagonal(const PyramidSettings& p) { return p.sides == kRegularSides && p.spreads.empty(); }

}  // namespace parhelion
