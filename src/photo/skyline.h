// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "photo/sky_colours.h"

namespace parhelion {

/// From 0 to 1 how clearly the colour changes between the pixel above and this one, over more than a smooth gradient
/// above would change it. Saturates early: a hazy ridge counts nearly as much as a black one.
Raster<float> horizontalEdges(const SkyScene& scene);

/// What makes a skyline good, in units of a column without any edge.
struct SkylinePrice {
  float passedEdge;  // an edge between the skyline and the upper border; negative asks for the lowest skyline
  float slope;       // one pixel up or down from one column to the next
};

/// The cheapest border from left to right, found column by column (Lie, Lin & Hung 2005, "A robust dynamic programming
/// algorithm to extract skyline in images for navigation"): the region above it.
Region aboveSkyline(const Raster<float>& edges, const SkylinePrice& price);

}  // namespace parhelion
