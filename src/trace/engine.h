// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>
#include <vector>

#include "trace/cloud.h"
#include "trace/embree_intersector.h"
#include "trace/planes_intersector.h"
#include "trace/trace_settings.h"

namespace parhelion {

/// Whatever finds the next face of one mesh.
using Intersector = std::variant<EmbreeIntersector, PlanesIntersector>;

/// One intersector a population, in the populations' order. Valid as long as the cloud.
using Engines = std::vector<Intersector>;

/// The engine asked for, or the planes where the choice is left and all crystals are convex.
Engine engineOf(const Cloud& cloud, Engine asked);

/// Throws std::runtime_error when Embree fails; without need of it, no Embree device is made.
Engines makeEngines(const Cloud& cloud, Engine engine);

}  // namespace parhelion
