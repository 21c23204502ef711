// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "scene/parse_scene.h"
#include "sky/tally.h"
#include "trace/trace.h"

namespace parhelion::bench {

struct TracedTally {
  Tally tally;
  TraceReport report;
};

/// Traces a scene as its own settings say.
TracedTally traceTally(const LoadedScene& loaded, const TraceControl& control = {});

/// The tally of a scene from a file if it is there and of the same scene, else traced and kept there.
Tally keptTally(const std::filesystem::path& path, const LoadedScene& loaded);

}  // namespace parhelion::bench
