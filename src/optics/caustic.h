// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "math/conventions.h"
#include "optics/sky_line.h"

namespace parhelion {

/// Where in the sky (unit world vector) crystals with two free angles (rad) send light; none where they send none.
using AnglesToSky = std::function<std::optional<Vec3>(double, double)>;

/// A range of one free angle (rad), looked at in so many steps.
struct AngleSteps {
  double from, to;
  int steps;
};

/// Where a map folds the angles over the sky: the lines that are bright edges, since there a small part of the sky gets
/// the light of many orientations. Folds that come and go within a step may go unseen, and a fold may lack its last
/// step where the light ends.
std::vector<SkyLine> foldsOf(const AnglesToSky& map, const AngleSteps& first, const AngleSteps& second);

}  // namespace parhelion
