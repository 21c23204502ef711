// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recon/published/allebach.h"

namespace parhelion {

/// The same for given values: `map` says where there is sky and which edges touch. Edges that do not touch need not
/// agree.
Reconstruction fitPolynomial(const HitMap& map, const KnownValues& known, double period, int iterations,
                             const Watch& watch);

}  // namespace parhelion
