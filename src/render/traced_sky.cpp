// SPDX-License-Identifier: Apache-2.0
#include "render/traced_sky.h"

#include "scene/traced_keys.h"
#include "trace/engine.h"
#include "trace/expose.h"
#include "trace/numerics.h"

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
  const TraceSettings chosen = chosenSettings(cloud, scene.trace);
  TallyInfo info;
  info.sceneHash = hashOf(talliedKeys(scene, chosen));
  info.numerics = kNumericsVersion;
  info.seed = chosen.seed;
  info.symmetry = countingOf(chosen.symmetry);
  info.white = cloud.spectrum().white();
  info.sunElevation = scene.sun.elevation;
  info.sunDiameter = scene.sun.diameter;
  info.camera = scene.camera;
  info.scene = loaded.text;
  info.version = PARHELION_VERSION;
  return Tally(info, cloud.spectrum().colours());
}

TracedSky traceSky(const LoadedScene& loaded, const Cloud& cloud, const TraceControl& control) {
  TracedSky traced{{}, chosenSettings(cloud, loaded.scene.trace), emptyTally(loaded, cloud)};
  traced.report = traceTally(traced.tally, cloud, traced.settings, 0, control);
  return traced;
}

}  // namespace parhelion
