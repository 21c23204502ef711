// SPDX-License-Identifier: Apache-2.0
#include "render/scene_attributes.h"

namespace parhelion {

ExrAttributes sceneAttributes(const LoadedScene& loaded, std::uint64_t rays) {
  return {{"software", kSoftware},
          {"parhelion:version", PARHELION_VERSION},
          {"parhelion:seed", std::to_string(loaded.scene.trace.seed)},
          {"parhelion:rays", std::to_string(rays)},
          {kSceneKey, loaded.text}};
}

}  // namespace parhelion
