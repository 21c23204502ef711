// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "photo/sky_colours.h"

namespace parhelion {

/// What speaks for a region to be the sky; everything from 0 to 1.
struct SkyMerit {
  double area = 0.0;        // share of the picture
  double edge = 0.0;        // how clear an edge its border is, on average
  double separation = 0.0;  // how well colours tell the region from the rest
  double thin = 0.0;        // share of it on lines thinner than a few pixels, as branches are

  double value() const;
};

SkyMerit skyMerit(const SkyScene& scene, const Region& sky);

/// The index of the region that is the sky. The best by its merit, but a smaller one inside it if a consistent edge and
/// other colours set the rest apart (the farthest of several ridges), and a larger one around it if no edge is between.
std::size_t chooseSky(const SkyScene& scene, const std::vector<Region>& regions, const std::vector<SkyMerit>& merits);

}  // namespace parhelion
