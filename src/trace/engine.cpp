// SPDX-License-Identifier: Apache-2.0
#include "trace/engine.h"

#include <algorithm>

namespace parhelion {

Engine engineOf(const Cloud& cloud, Engine asked) {
  const auto isConvex = [](const Population& population) { return population.mesh().isConvex(); };
  return asked == Engine::automatic && std::ranges::all_of(cloud.populations(), isConvex) ? Engine::planes : asked;
}

Engines makeEngines(const Cloud& cloud, Engine engine) {
  const EmbreeMode mode = engine == Engine::embreeRobust ? EmbreeMode::robust : EmbreeMode::fast;
  std::optional<EmbreeDevice> device;
  Engines engines;
  for (const Population& population : cloud.populations()) {
    const CrystalMesh& mesh = population.mesh();
    if (engine == Engine::planes || (engine == Engine::automatic && mesh.isConvex())) {
      engines.emplace_back(PlanesIntersector(mesh));
      continue;
    }
    if (!device) device.emplace();
    engines.emplace_back(EmbreeIntersector(*device, mesh, mode));
  }
  return engines;
}

}  // namespace parhelion
