// SPDX-License-Identifier: Apache-2.0
// Compiled once for each set of vector registers, with PARHELION_LANES doubles side by side. Nothing here may be shared
// with code for other registers: everything is local to the file, inlined, or a template of this file's lanes.
#include "trace/lane_exits.h"
#include "trace/lane_incidence.h"
#include "trace/lane_paths.h"

namespace parhelion {

#define PARHELION_PASTE(a, b) a##b
#define PARHELION_LANE_STEPS(lanes) PARHELION_PASTE(laneStepsOf, lanes)

extern const LaneSteps PARHELION_LANE_STEPS(PARHELION_LANES);
const LaneSteps PARHELION_LANE_STEPS(PARHELION_LANES) = {
    .lanes = kLanes,
    .draw = draw,
    .propose = propose,
    .enter = {{enter<PathRecord::nothing, false>, enter<PathRecord::state, false>, enter<PathRecord::sequence, false>},
              {enter<PathRecord::nothing, true>, enter<PathRecord::state, true>, enter<PathRecord::sequence, true>}},
    .findFaces = findFaces,
    .measureFaces = measureFaces,
    .meetFaces = {{meetFaces<PathRecord::nothing, false>, meetFaces<PathRecord::state, false>,
                   meetFaces<PathRecord::sequence, false>},
                  {meetFaces<PathRecord::nothing, true>, meetFaces<PathRecord::state, true>,
                   meetFaces<PathRecord::sequence, true>}},
    .turnToWorld = turnToWorld,
    .see = see};

}  // namespace parhelion
