// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "picture/image.h"
#include "scene/scene.h"
#include "sky/light_map.h"
#include "trace/cloud.h"
#include "trace/light_path.h"

namespace parhelion {

// What is measured of a scene without its camera. Every ray counts for itself, whatever the sky's symmetry.

/// What a run's settings come to for them (chosenSettings()).
TraceSettings settingsOfMeasurement(const Cloud& cloud, const TraceSettings& asked);

/// A map as a picture: channels Y (energy a bin) and stderr, the zenith's row on top.
Image mapPicture(const LightMap& map);

/// The whole life of one of the scene's rays, with all its encounters. `cloud` is the scene's; the path is valid as
/// long as it lives.
LightPath replayRay(const Scene& scene, const Cloud& cloud, std::uint64_t ray);

}  // namespace parhelion
