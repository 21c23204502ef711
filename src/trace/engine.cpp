// SPDX-License-Identifier: Apache-2.0
#include "trace/engine.h"

namespace parhelion {

Engines makeEngines(const Cloud& cloud, Engine engine) {
  const EmbreeDevice device;
  const EmbreeMode mode = engine == Engine::embreeRobust ? EmbreeMode::robust : EmbreeMode::fast;
  Engines engines;
  for (const Population& population : cloud.populations()) engines.emplace_back(device, population.mesh(), mode);
  return engines;
}

}  // namespace parhelion
