// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "beam/band_store.h"
#include "beam/sky_integral.h"

namespace parhelion {

/// Whether a scene is one for integrateTilts(): tilts that differ, or a sun with a disc, in pixels that are not much
/// finer than what these blur.
bool isForTilts(const AxisScene& scene, const Camera& camera);

/// Bytes that integrateTilts() takes at most beside the picture's pixels, of a sun with a disc of that radius (rad).
std::uint64_t memoryForTilts(const Camera& camera, double sunRadius, double error);

/// integrateSky() of crystals of all tilts together (TiltSky): for suns with a disc, light of all colours and
/// distributions of tilts.
SkyIntegral integrateTilts(const AxisScene& scene, const SkyAccuracy& accuracy, const Camera& camera, BandStore& store);

}  // namespace parhelion
