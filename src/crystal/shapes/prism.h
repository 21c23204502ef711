// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "crystal/crystal_mesh.h"
#include "crystal/distributions.h"

namespace parhelion {

/// Hexagonal prism: a plate for aspect below 1, a column (a "pencil") above.
struct PrismSettings {
  static constexpr std::string_view kName = "prism";
  AspectDistribution aspect = FixedValue{1.0};
};

/// Hexagonal prism centred on the origin, hexagon side 1, length 2 * `aspect` along c. Faces 1-8.
CrystalMesh hexagonalPrism(double aspect);

CrystalMesh meshOf(const PrismSettings& prism);
std::optional<AngleDistribution> stretchOf(const PrismSettings& prism);
inline bool hasEndsAlike(const PrismSettings&) { return true; }

}  // namespace parhelion
