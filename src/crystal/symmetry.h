// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "crystal/isometry.h"
#include "crystal/population_settings.h"

namespace parhelion {

/// Whether a population is unchanged by the reflection y -> -y of the world, in the vertical plane through the sun.
/// That is so if every orientation has an equally likely counterpart whose crystal is its mirror image. Then the
/// population's sky is unchanged, too.
///
/// The answer true is certain. The answer false may be wrong for a few symmetric settings that no display asks for.
bool isMirrorSymmetric(const PopulationSettings& population);

/// Whether every rotation is equally likely. Then the light of each point of the sun depends only on the angle from
/// that point, and the light of the whole round disc only on the angle from its centre.
bool isFullyRandom(const PopulationSettings& population);

/// Whether a distribution of orientations is unchanged when every crystal is replaced by its image under `isometry`,
/// for an improper one also reflected in the vertical plane through the sun, so that faces stay where faces were. Light
/// that met some faces then has an equally likely counterpart that met their images, at the same place of the sky or at
/// its mirror image.
///
/// The answer true is certain. The answer false may be wrong for a few settings that no display asks for.
bool keepsOrientations(const OrientationSettings& orientation, const Isometry& isometry);

/// The first population for which `holds` is false; null if there is none.
const PopulationSettings* firstWithout(bool (*holds)(const PopulationSettings&),
                                       std::span<const PopulationSettings> populations);

}  // namespace parhelion
