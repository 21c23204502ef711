// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "photo/min_cut.h"
#include "photo/sky_colours.h"

namespace parhelion {

/// The sky with everything added that a walk reaches whose every step changes the colour by less than `largestStep`;
/// then what is seen of the sky through gaps: patches of land whose colour is that of the sky on the same rows. Land
/// that does not reach the lower border counts as sky, a dark cloud for instance.
Region grownSky(const SkyScene& scene, const Region& sky, float largestStep);

/// The sky with all land added that does not hang together, corner to corner, with the lower border: a dark cloud.
Region withoutIslands(const Region& sky);

/// Finds the sky whose colours and borders fit the picture best, near a first guess: a minimal cut between colours
/// learnt from the guess, cheapest along edges (Rother, Kolmogorov & Blake 2004, "GrabCut").
class SkyCut {
 public:
  explicit SkyCut(const SkyScene& scene);
  /// Connected to the upper border.
  Region operator()(const Region& guess) const;

 private:
  const SkyScene& scene_;
  Raster<float> rough_;  // how rough the picture is about each pixel, 0 to 1: sky is smooth, land need not be
  MinCut links_;         // the cost of parting neighbours, the same for all guesses
};

}  // namespace parhelion
