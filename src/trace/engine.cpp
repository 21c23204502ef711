// SPDX-License-Identifier: Apache-2.0
#include "trace/engine.h"

#include <algorithm>

namespace parhelion {

Engine engineOf(const Cloud& cloud, Engine asked) {
  const auto isConvex = [](const Population& population) { return population.mesh().isConvex(); };
  return asked == Engine::automatic && std::ranges::all_of(cloud.populations(), isConvex) ? Engine::planes : asked;
}

Intersectors makeIntersectors(const Cloud& cloud, Engine engine) {
  EngineDevices devices;
  Intersectors engines;
  for (const Population& population : cloud.populations())
    engines.push_back(makeIntersector(engine, population.mesh(), devices));
  return engines;
}

}  // namespace parhelion
