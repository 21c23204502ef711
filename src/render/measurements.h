// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "picture/image.h"
#include "render/traced_sky.h"
#include "trace/light_path.h"
#include "trace/scatter_profile.h"
#include "trace/sky_map.h"

namespace parhelion {

// What is measured of a scene without its camera. Every ray counts for itself, whatever the sky's symmetry.

/// What a run's settings come to for them (chosenSettings()).
TraceSettings settingsOfMeasurement(const Cloud& cloud, const TraceSettings& asked);

struct TracedMap : TracedScene {
  SkyMap map;
};
struct TracedProfile : TracedScene {
  ScatterProfile profile;
};

/// The scene's light over azimuth and elevation of the whole sphere, in SkyMap's bins.
TracedMap traceMap(const Scene& scene, int binsPerHalfTurn, const TraceControl& control = {});

/// A map as a picture: channels Y (energy a bin) and stderr, the zenith's row on top.
Image mapPicture(const SkyMap& map);

/// The scene's light over the scattering angle, in `bins` equal bins over [from, to] (rad).
TracedProfile traceProfile(const Scene& scene, int bins, double from, double to, const TraceControl& control = {});

/// The whole life of one of the scene's rays, with all its encounters. `cloud` is the scene's; the path is valid as
/// long as it lives.
LightPath replayRay(const Scene& scene, const Cloud& cloud, std::uint64_t ray);

}  // namespace parhelion
