// SPDX-License-Identifier: Apache-2.0
#include "trace/sky_film.h"

namespace parhelion {

void SkyFilm::add(std::span<const LightPath> bundle) {
  deposits_.clear();
  for (const LightPath& path : bundle) {
    const SpectralSample& light = path.incident.light;
    intercepted_ += toFixed(path.incident.weight * light.light);
    for (const Exit& exit : path.exits) {
      if (exit.undeviated)
        undeviated_ += toFixed(exit.energy * light.light);
      else if (const auto pixel = camera_.pixelAt(-exit.lightDirWorld))
        deposits_.add(*pixel, exit.energy * light.xyz);
    }
  }
  const bool firstHalf = bundle.front().incident.bundle % 2 == 0;
  for (const auto& [pixel, xyz] : deposits_.all()) buffer_.add(pixel, xyz, firstHalf);
}

void SkyFilm::merge(PathTally& fromThread) {
  auto& other = dynamic_cast<SkyFilm&>(fromThread);
  other.buffer_.flush();
  tally_.info.intercepted += other.intercepted_;
  tally_.info.undeviated += other.undeviated_;
}

}  // namespace parhelion
