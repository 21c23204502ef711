// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "crystal/crystal_mesh.h"
#include "crystal/distributions.h"
#include "math/conventions.h"

namespace parhelion {

/// A bullet rosette: hexagonal columns with a flat end outside and a pyramid inside, whose apexes meet in the centre,
/// or overlap there.
struct RosetteSettings {
  static constexpr std::string_view kName = "rosette";
  static constexpr int kMostBullets = 8;
  int bullets = 6;               // 1 to kMostBullets
  double aspect = 2.0;           // of the prism part of a bullet, L / 2a
  double slope = radians(28.0);  // angle between a face of its pyramid and its c axis
  double overlap = 0.0;          // how far it reaches beyond the centre, as a share of its pyramid's height, [0, 1]
};

/// Where the bullets of a rosette point to: as far from each other as they can, along the crystal's c axis and around
/// it. One, two opposite each other, an equilateral triangle, a tetrahedron, a triangle with two poles, an octahedron,
/// a pentagon with two poles, and a cube that stands on a corner. In ice their c axes are 70.53 or 109.47 degrees apart
/// (Kobayashi et al. 1976), as those of 4 and 8 are.
std::vector<Mat3> bulletFrames(int bullets);

/// The crystal, hexagon side 1. Face k of bullet b, from 0, is number 100 b + k: 1 the end, 3-8 the prism, 23-28 the
/// pyramid. Of a single bullet it is convex and stands along c. Throws std::invalid_argument where bullets meet in a
/// corner or an edge, and others in more, or nearly so.
CrystalMesh meshOf(const RosetteSettings& rosette);

inline std::optional<AngleDistribution> stretchOf(const RosetteSettings&) { return std::nullopt; }
inline bool hasEndsAlike(const RosetteSettings&) { return false; }
inline bool isHexagonal(const RosetteSettings&) { return false; }

}  // namespace parhelion
