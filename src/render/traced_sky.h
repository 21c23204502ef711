// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scene/parse_scene.h"
#include "sky/sky_tally.h"
#include "trace/cloud.h"
#include "trace/trace.h"

namespace parhelion {

/// The cloud of a scene, with its rays shared out as the scene says.
Cloud cloudOf(const Scene& scene);

/// The same for what is measured without a camera: rays are shared out as light is.
Cloud cloudByLight(const Scene& scene);

/// What a run's settings come to in a cloud: engine and symmetry are chosen where the scene leaves the choice. The
/// engine stays `automatic` where not all crystals are convex, for then each gets its own.
TraceSettings chosenSettings(const Cloud& cloud, const TraceSettings& asked);

/// A scene traced into the tally of its camera.
struct TracedSky {
  TraceReport report;
  TraceSettings settings;  // as chosen
  SkyTally tally;
};

/// What is known of a scene's sky before any light is in it, but for what its light is traced by.
TallyInfo skyInfoOf(const LoadedScene& loaded);

/// A tally of a scene's camera with all that is known before its rays are traced by this version of the program.
/// `cloud` is the scene's.
SkyTally emptyTally(const LoadedScene& loaded, const Cloud& cloud);

/// Traces a scene into the tally of its camera, with all that the tally's info says filled in. `cloud` is the scene's.
/// Where the control stops the run, the tally is that of the rays traced until then. The same bits for any number of
/// threads. Throws as traceRays() does.
TracedSky traceSky(const LoadedScene& loaded, const Cloud& cloud, const TraceControl& control = {});

}  // namespace parhelion
