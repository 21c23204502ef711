// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "beam/tristimulus.h"
#include "optics/sun.h"
#include "sky/tally_info.h"

namespace parhelion {

/// Light by rings of equal angle about the sun, or about one of its points.
struct Rings {
  std::vector<Tristimulus> light;
  std::vector<double> error;
};

/// Rings about the sun's centre, of rings about each of its points.
Rings widened(const Rings& rings, const Sun& sun);

/// The light of rings in the pixels of the camera that `info` has.
std::vector<Tristimulus> spread(const std::vector<Tristimulus>& rings, const TallyInfo& info, int colours);

}  // namespace parhelion
