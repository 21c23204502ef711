// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "crystal/convex_body.h"
#include "crystal/distributions.h"

namespace parhelion {

/// Any convex crystal, by the planes of its faces.
struct PlanesSettings {
  static constexpr std::string_view kName = "planes";
  std::vector<FacePlane> planes = {};
};

inline CrystalMesh meshOf(const PlanesSettings& crystal) { return convexBody(crystal.planes); }
inline std::optional<AngleDistribution> stretchOf(const PlanesSettings&) { return std::nullopt; }
inline bool hasEndsAlike(const PlanesSettings&) { return false; }
inline bool isHexagonal(const PlanesSettings&) { return false; }

}  // namespace parhelion
