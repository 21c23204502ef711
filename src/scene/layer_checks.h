// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toml++/toml.h>

#include "scene/complaints.h"
#include "scene/scene.h"

namespace parhelion {

/// Complains about layers and a filter that name populations which the scene does not have, or halos that none of them
/// makes.
void checkLayers(const toml::table& root, Scene& scene, Complaints& complaints);

/// Where the scene says `layers = "populations"`: a layer for each.
void addLayerPerPopulation(const toml::table& root, Scene& scene, Complaints& complaints);

}  // namespace parhelion
