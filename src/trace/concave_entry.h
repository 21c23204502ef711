// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "trace/concave_crystal.h"
#include "trace/lane_steps.h"

namespace parhelion {

/// LaneSteps::propose for crystals of any form. A point is drawn of all that looks toward the light; where another part
/// of the crystal lies before it, it is rejected. So crystals are taken in proportion to their silhouettes, and points
/// are uniform over these. The queue's shadow is an estimate of the silhouette whose inverse has the right mean.
void proposeConcave(const ConcaveCrystal& crystal, const IncidenceTable& table, const IncidenceNumbers& numbers,
                    Proposals& proposals, RayQueue& queue);

}  // namespace parhelion
