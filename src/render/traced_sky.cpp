// SPDX-License-Identifier: Apache-2.0
#include "render/traced_sky.h"

#include "render/air_background.h"
#include "render/allocation.h"
#include "scene/traced_keys.h"
#include "trace/engine.h"
#include "trace/expose.h"
#include "trace/numerics.h"

namespace parhelion {

Cloud cloudByLight(const Scene& scene) { return Cloud(sunAtCloud(scene), scene.ice, scene.populations); }

Cloud cloudOf(const Scene& scene) {
  Cloud byLight = cloudByLight(scene);
  if (scene.trace.allocation == Allocation::light) return byLight;
  std::vector<double> favours = favoursFor(scene, byLight);
  if (favours.empty()) return byLight;
  return Cloud(sunAtCloud(scene), scene.ice, scene.populations, std::move(favours));
}

TraceSettings chosenSettings(const Cloud& cloud, const TraceSettings& asked) {
  TraceSettings chosen = asked;
  chosen.engine = engineOf(cloud, asked.engine);
  chosen.symmetry = symmetryOf(cloud, asked.symmetry);
  return chosen;
}

TallyInfo skyInfoOf(const LoadedScene& loaded) {
  const Scene& scene = loaded.scene;
  TallyInfo info;
  info.white = Spectrum(sunAtCloud(scene).spectrum).white();
  info.sunElevation = scene.sun.elevation;
  info.sunDiameter = scene.sun.diameter;
  info.camera = scene.camera;
  info.scene = loaded.text;
  info.version = PARHELION_VERSION;
  return info;
}

SkyTally emptyTally(const LoadedScene& loaded, const Cloud& cloud) {
  const TraceSettings chosen = chosenSettings(cloud, loaded.scene.trace);
  TallyInfo info = skyInfoOf(loaded);
  info.sceneHash = hashOf(talliedKeys(loaded.scene, chosen));
  info.numerics = kNumericsVersion;
  info.seed = chosen.seed;
  std::vector<std::string> layers;
  for (const LayerSettings& layer : chosen.paths.layers) layers.push_back(layer.name);
  return SkyTally(info, cloud.spectrum().colours(), different(symmetriesOf(cloud, chosen.symmetry)), layers);
}

TracedSky traceSky(const LoadedScene& loaded, const Cloud& cloud, const TraceControl& control) {
  TracedSky traced{{}, chosenSettings(cloud, loaded.scene.trace), emptyTally(loaded, cloud)};
  traced.report = traceTally(traced.tally, cloud, traced.settings, 0, control);
  return traced;
}

}  // namespace parhelion
