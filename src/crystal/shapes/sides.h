// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "crystal/convex_body.h"

namespace parhelion {

/// Distances of faces 3-8 from the c axis, over those of the regular hexagon of side 1. A face may lie so far out that
/// nothing of it is left, or beyond the axis, where its distance is negative.
using Sides = std::array<double, 6>;

inline constexpr Sides kRegularSides{1.0, 1.0, 1.0, 1.0, 1.0, 1.0};

/// The planes of prism faces 3-8, or of others that stand like them at `slope` (rad) to the c axis and meet the prism's
/// at height `z`, numbered from `firstNumber`. They look up for a slope above 0, down below.
std::vector<FacePlane> sidePlanes(const Sides& sides, int firstNumber = 3, double slope = 0.0, double z = 0.0);

/// The planes of faces 1 and 2 at these heights.
std::vector<FacePlane> endPlanes(double upper, double lower);

}  // namespace parhelion
