// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <toml++/toml.h>

#include "scene/complaints.h"
#include "scene/scene.h"

namespace parhelion {

/// Complains about layers and a filter that name populations which the scene does not have, or halos that none of them
/// makes.
void checkLayers(const toml::table& root, Scene& scene, Complaints& complaints);

/// Complains about layers of a cloud that name what the scene does not have, and about populations that are in none.
void checkCloudLayers(const toml::table& root, const Scene& scene, Complaints& complaints);

/// Where the scene says `layers = "populations"`, or has a cloud of layers, whose populations are in the light of the
/// sun and in sight each in its own way: a layer for each.
void addLayerPerPopulation(const toml::table& root, Scene& scene, Complaints& complaints);

}  // namespace parhelion
