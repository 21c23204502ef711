// SPDX-License-Identifier: Apache-2.0
#include "trace/engine.h"

#include <algorithm>

namespace parhelion {

Engine engineOf(const Cloud& cloud, Engine asked) {
  const auto isConvex = [](const Population& population) { return population.mesh().isConvex(); };
  if (asked != Engine::automatic) return asked;
  return std::ranges::all_of(cloud.populations(), isConvex) ? Engine::planes : Engine::embree;
}

Intersectors makeIntersectors(const Cloud& cloud, Engine engine) {
  EngineDevices devices;
  Intersectors engines;
  for (int p = 0; p < static_cast<int>(cloud.populations().size()); ++p) {
    const ConcaveCrystal* concave = cloud.concave(p);
    if (concave && engine != Engine::planes)
      engines.emplace_back(ConcaveIntersector{concave});
    else
      engines.push_back(makeIntersector(engine, cloud.populations()[p].mesh(), devices));
  }
  return engines;
}

}  // namespace parhelion
