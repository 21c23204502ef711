// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "crystal/population_settings.h"
#include "optics/halo_makers.h"

namespace parhelion {

/// What a scene's populations are to halos.
struct SceneHalos {
  std::vector<HaloMaker> makers;
  std::vector<std::string> nameless;  // populations that stand in a way whose halos have no names
};

/// Families by how crystals really stand, whatever they are called: plates, columns and Lowitz plates have two thirds
/// of their axes within 15 degrees of rest, Parry columns two thirds of their faces within 10, too. All that tilts
/// farther makes rings, as crystals in all orientations do, unless its axes keep to another zenith angle. Populations
/// without weight are left out.
SceneHalos halosOf(const std::vector<PopulationSettings>& populations);

}  // namespace parhelion
