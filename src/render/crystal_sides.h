// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "scene/scene.h"

namespace parhelion {

/// The altitude (m) of a cloud that has air before it; none: crystals float around the observer.
inline std::optional<double> cloudAltitude(const Scene& scene) {
  if (!scene.cloud || scene.cloud->altitude == scene.observer.altitude) return {};
  return scene.cloud->altitude;
}

/// On which sides of the horizon crystals are seen: on both where there is no air, and so no ground, and where they
/// float around an observer in the air.
struct CrystalSides {
  bool above, below;

  bool has(const Vec3& toSky) const { return toSky.z > 0.0 ? above : below; }
};

inline CrystalSides crystalSides(const Scene& scene) {
  if (!scene.sky.air) return {true, true};
  const double observer = scene.observer.altitude;
  const std::optional<double> cloud = cloudAltitude(scene);
  return {!cloud || *cloud > observer, cloud ? *cloud < observer : observer > 0.0};
}

}  // namespace parhelion
