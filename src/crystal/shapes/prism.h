// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "crystal/crystal_mesh.h"
#include "crystal/distributions.h"
#include "crystal/shape_spread.h"
#include "crystal/shapes/notch.h"
#include "crystal/shapes/prism_ends.h"
#include "crystal/shapes/sides.h"

namespace parhelion {

/// Hexagonal prism: a plate for aspect below 1, a column (a "pencil") above.
struct PrismSettings {
  static constexpr std::string_view kName = "prism";
  AspectDistribution aspect = FixedValue{1.0};
  Sides sides = kRegularSides;
  std::vector<ShapeSpread> spreads = {};  // of sides, and of aspects that are more than stretched
  PrismEnd upper = {}, lower = {};
  Notch notch = {};

  /// Without pits, caps and notches.
  bool isPlain() const { return !upper.isThere() && !lower.isThere() && !notch.isThere(); }
};

/// Hexagonal prism centred on the origin, hexagon side 1, length 2 * `aspect` along c. Faces 1-8.
CrystalMesh hexagonalPrism(double aspect);

CrystalMesh meshOf(const PrismSettings& prism);
std::optional<AngleDistribution> stretchOf(const PrismSettings& prism);
inline bool hasEndsAlike(const PrismSettings& prism) { return prism.upper == prism.lower; }
inline bool isHexagonal(const PrismSettings& prism) { return prism.sides == kRegularSides && prism.spreads.empty(); }

}  // namespace parhelion
