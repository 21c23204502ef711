// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "photo/sky_colours.h"

namespace parhelion {

/// The sky with everything added that a walk reaches whose every step changes the colour by less than `largestStep`;
/// then what is seen of the sky through gaps: patches of land whose colour is that of the sky on the same rows. Land
/// that does not reach the lower border counts as sky, a dark cloud for instance.
Region grownSky(const SkyScene& scene, const Region& sky, float largestStep);

/// The sky with all land added that does not hang together, corner to corner, with the lower border: a dark cloud.
Region withoutIslands(const Region& sky);

/// The sky whose colours and borders fit the picture best, near a first guess: a minimal cut between colours learnt
/// from the guess, cheapest along edges (Rother, Kolmogorov & Blake 2004, "GrabCut"). Connected to the upper border.
Region cutSky(const SkyScene& scene, const Region& guess);

}  // namespace parhelion
