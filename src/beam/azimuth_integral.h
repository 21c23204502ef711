// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "beam/sky_integral.h"

namespace parhelion {

/// integrateSky() of crystals that stand alike but for their azimuths, which are free.
SkyIntegral integrateAzimuths(const AxisScene& scene, const SkyAccuracy& accuracy, const Camera& camera);

/// Bytes that integrateAzimuths() takes at most beside the picture's pixels, of a sun with a disc of that radius (rad).
std::uint64_t memoryForAzimuths(double sunRadius, double error);

}  // namespace parhelion
