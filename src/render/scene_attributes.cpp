// SPDX-License-Identifier: Apache-2.0
#include "render/scene_attributes.h"

#include <cstdio>

namespace parhelion {

ExrAttributes sceneAttributes(const LoadedScene& loaded, std::uint64_t rays) {
  ExrAttributes attributes{{"software", kSoftware},
                           {"parhelion:version", PARHELION_VERSION},
                           {"parhelion:seed", std::to_string(loaded.scene.trace.seed)},
                           {"parhelion:rays", std::to_string(rays)},
                           {kSceneKey, loaded.text}};
  if (loaded.error) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", *loaded.error);
    attributes[kErrorKey] = text;
  }
  return attributes;
}

}  // namespace parhelion
