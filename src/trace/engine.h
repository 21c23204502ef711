// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "trace/cloud.h"
#include "trace/embree_intersector.h"
#include "trace/trace_settings.h"

namespace parhelion {

/// One intersector a population, in the populations' order. Valid as long as the cloud.
using Engines = std::vector<EmbreeIntersector>;

/// Throws std::runtime_error when Embree fails.
Engines makeEngines(const Cloud& cloud, Engine engine);

}  // namespace parhelion
