// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "render/integrated_sky.h"
#include "sky/light_map.h"
#include "trace/trace.h"

namespace parhelion {

/// What integrates as much of a scene's light as can be, where the scene leaves the choice of the engine to us; what it
/// has where nothing can, or the choice is made.
Engine integratingEngine(const Scene& scene);

/// The scene with those of its populations alone that have light and cannot be integrated; none if all can.
std::optional<LoadedScene> onlyTraced(const LoadedScene& loaded);

/// The share of a scene's light that meets populations which cannot be integrated, by a pilot sample.
double tracedShareOf(const Scene& scene);

/// How good a mixed picture is to be.
struct MixGoal {
  double error;                           // of what is integrated; of the whole picture where rays may end early
  bool raysEndEarly = false;              // once that is reached
  std::function<bool(double)> goOn = {};  // SkyAccuracy
};

/// A sky whose populations were each made by the engine that serves it.
struct MixedSky {
  IntegratedSky sky;                            // of all, and its error; its rays are those that were traced
  std::vector<std::string> integrated, traced;  // names of the populations
  double tracedShare = 0.0;                     // of the light, by a pilot sample
  double secondsIntegrated = 0.0, secondsTraced = 0.0;
  TraceReport report;  // of the rays, if there are any
};

/// The rays that a scene's picture takes: none where all is integrated, else the scene's.
std::uint64_t raysOf(const Scene& scene);

/// Integrates the populations that can be to so small an error; traces rays for all others, the scene's at most, and
/// reconstructs those as the scene says. The same bits for any number of threads. Throws as traceRun() and
/// lightPartsOf() do. Where the control stops the rays, `report` says so; where the goal is not to go on, `sky` does.
MixedSky mixSky(const LoadedScene& loaded, const MixGoal& goal, const TraceControl& control = {},
                LightStore* store = nullptr);

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
