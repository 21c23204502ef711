// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/integrated_sky.h"
#include "sky/light_map.h"
#include "trace/trace.h"

namespace parhelion {

/// A sky whose populations were each made by the engine that serves it.
struct MixedSky {
  IntegratedSky sky;                            // of all; its rays are those that were traced
  std::vector<std::string> integrated, traced;  // names of the populations
  double tracedShare = 0.0;                     // of the light, by a pilot sample
  double secondsIntegrated = 0.0, secondsTraced = 0.0;
  TraceReport report;  // of the rays, if there are any
};

/// The rays that a scene's picture takes: none where all is integrated, else the scene's.
std::uint64_t raysOf(const Scene& scene);

/// Integrates the populations that can be to so small an error; traces the scene's rays for all others, and
/// reconstructs those as the scene says. The same bits for any number of threads. Throws as traceRays() and
/// lightPartsOf() do. Where the control stops the rays, `report` says so.
MixedSky mixSky(const LoadedScene& loaded, double error, const TraceControl& control = {}, LightStore* store = nullptr);

/// Light over the whole sphere as SkyMap has it, each population's made by the engine that serves it.
struct MixedMap {
  LightMap light;
  MixedSky made;  // its figures, without the picture
};

/// The picture that a map is made of has so many pixels across a bin and up: an even number.
int pixelsPerBin(int binsPerHalfTurn);

/// The scene whose picture a map of so many bins is made of, without layers.
LoadedScene sceneOfMap(const LoadedScene& loaded, int binsPerHalfTurn);

/// As mixSky() for the map of a scene; errors of a bin's pixels are taken to go together.
MixedMap mixMap(const LoadedScene& loaded, int binsPerHalfTurn, double error, const TraceControl& control = {});

}  // namespace parhelion
