// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recon/published/allebach.h"

namespace parhelion {

/// Adaptive weights and conjugate gradients on Toeplitz matrices: the trigonometric polynomial nearest to the hits,
/// each weighted by the area of its Voronoi cell, approached from the mean in `iterations` steps. The steps are chosen
/// by the first light; all others take the same. Feichtinger, Groechenig & Strohmer, Efficient numerical methods in
/// non-uniform sampling theory, 1995.
Reconstruction act(const HitMap& map, const ActSettings& settings, const Watch& watch);

/// The same for given values: `map` says where there is sky and which edges touch. Edges that do not touch need not
/// agree.
Reconstruction fitPolynomial(const HitMap& map, const KnownValues& known, double period, int iterations,
                             const Watch& watch);

}  // namespace parhelion
