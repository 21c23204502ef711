// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace parhelion {

/// A setting that decides what becomes of a ray: "sun.elevation" and "0.3490658503988659", in the units of settings.
struct TracedKey {
  std::string key, value;

  bool operator==(const TracedKey&) const = default;
};

/// All that decides the light of ray n of a seed, however the scene file spells it: sun, ice, populations in their
/// order, and what finds faces, paths and numbers. Not the seed and the number of rays, nor what becomes of the light
/// afterwards: the camera, the reconstruction, whether the sun is drawn. `trace` has engine and symmetry as chosen.
///
/// What a file holds that a scene names belongs in here, too, as its content. A key that is new comes into the list
/// only where it differs from its default, so that the hashes of scenes without it stay what they were.
std::vector<TracedKey> tracedKeys(const Scene& scene, const TraceSettings& trace);

/// The same with the camera: what decides a tally. Symmetry matters here.
std::vector<TracedKey> talliedKeys(const Scene& scene, const TraceSettings& trace);

/// The checksum (math/checksum.h) of the lines "key=value\n".
std::uint64_t hashOf(const std::vector<TracedKey>& keys);

}  // namespace parhelion
