// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "crystal/population_settings.h"

namespace parhelion {

/// Whether a population is unchanged by the reflection y -> -y of the world, in the vertical plane through the sun: to
/// every orientation belongs an equally likely one that holds the mirror image of the crystal. Then so is its sky.
/// Certain when true; false also for a few symmetric settings that no display asks for.
bool isMirrorSymmetric(const PopulationSettings& population);

/// Whether every rotation is equally likely. Then the light of each point of the sun depends on nothing but the angle
/// from that point, and that of the whole round disc on nothing but the angle from its centre.
bool isFullyRandom(const PopulationSettings& population);

/// The first population for which `holds` does not; null when there is none.
const PopulationSettings* firstWithout(bool (*holds)(const PopulationSettings&),
                                       std::span<const PopulationSettings> populations);

}  // namespace parhelion
