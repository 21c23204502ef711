// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/run_options.h"
#include "picture/exr.h"
#include "sky/tally.h"

namespace parhelion::cli {

/// Under these our pictures carry the scene they were made from and, photographs with a halo in them, its strength.
inline constexpr const char* kSceneKey = "parhelion:scene";
inline constexpr const char* kStrengthKey = "parhelion:strength";

struct TallyRun {
  Tally tally;
  RunResult result;
};

/// Traces a scene into the tally of its camera, with all that the tally's info says filled in.
TallyRun traceTally(const RunOptions& options, const LoadedScene& loaded, const Cloud& cloud, const StopSignal& stop);

/// What every EXR of ours says about itself: the program, and the scene with which it can be made again.
ExrAttributes sceneAttributes(const LoadedScene& loaded, std::uint64_t rays);

}  // namespace parhelion::cli
