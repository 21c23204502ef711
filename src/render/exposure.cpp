// SPDX-License-Identifier: Apache-2.0
#include "render/exposure.h"

#include "trace/engine.h"
#include "trace/film.h"

namespace parhelion {

Cloud cloudOf(const Scene& scene) { return Cloud(scene.sun, scene.ice, scene.populations); }

TraceSettings chosenSettings(const Cloud& cloud, const TraceSettings& asked) {
  TraceSettings chosen = asked;
  chosen.engine = engineOf(cloud, asked.engine);
  chosen.symmetry = symmetryOf(cloud, asked.symmetry);
  return chosen;
}

Tally emptyTally(const LoadedScene& loaded, const Cloud& cloud) {
  const Scene& scene = loaded.scene;
  TallyInfo info;
  info.seed = scene.trace.seed;
  info.white = cloud.spectrum().white();
  info.sunElevation = scene.sun.elevation;
  info.sunDiameter = scene.sun.diameter;
  info.camera = scene.camera;
  info.scene = loaded.text;
  info.version = PARHELION_VERSION;
  return Tally(info, cloud.spectrum().colours());
}

Exposure expose(const LoadedScene& loaded, const Cloud& cloud, const TraceControl& control) {
  Exposure exposure{{{}, chosenSettings(cloud, loaded.scene.trace)}, emptyTally(loaded, cloud)};
  exposure.report = exposeTally(exposure.tally, cloud, exposure.settings, 0, control);
  return exposure;
}

}  // namespace parhelion
