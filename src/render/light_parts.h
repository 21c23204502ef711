// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "beam/wanted_paths.h"
#include "scene/scene.h"

namespace parhelion {

/// Light of a population that is integrated by itself: that of one layer, as far as a filter keeps it.
struct LightPart {
  std::size_t layer;                  // the scene's, then the rest; 0 if there are none
  std::optional<WantedPaths> wanted;  // none: all of the population's
};

/// The parts of one population of prisms, at least one.
using LightParts = std::vector<LightPart>;

/// By population. Those that objectionsToIntegrating() has something against have none. Throws std::invalid_argument
/// for a scene whose patterns PathPlan throws for.
std::vector<LightParts> lightPartsOf(const Scene& scene);

/// By population: why its light cannot be integrated, as a predicate such as "has crystals that are no prisms"; empty
/// where it can. Throws as lightPartsOf().
std::vector<std::string> objectionsToIntegrating(const Scene& scene);

/// By population, all of which must be prisms: what a filter keeps of its light; none: all. Throws as lightPartsOf().
std::vector<std::optional<WantedPaths>> keptPathsOf(const Scene& scene);

}  // namespace parhelion
