// SPDX-License-Identifier: Apache-2.0
#include "trace/radial_film.h"

namespace parhelion {

int RadialFilm::add(const TracedRays& traced) {
  const auto& [queue, exits, members, mesh, steps] = traced;
  byBundle_.sort(queue, exits.ray, exits.count);
  int seen = 0;
  for (int place = 0; place < queue.count; ++place) {
    for (int member = 0; member < members; ++member)
      intercepted_ += toFixed(queue.weight[place] * queue.light[queue.ray(member, place)].light);
    deposits_.clear();
    for (int i = byBundle_.begin(place); i < byBundle_.begin(place + 1); ++i) {
      const int exit = byBundle_.item(i);
      const SpectralSample& light = queue.light[static_cast<int>(exits.ray[exit])];
      if (exits.undeviated[exit] != 0.0) {
        undeviated_ += toFixed(exits.energy[exit] * light.light);
      } else {
        deposits_.add(sky_.binAt(-exits.lightDir(exit)), exits.energy[exit] * light.xyz);
        ++seen;
      }
    }
    const bool firstHalf = queue.bundle[place] % 2 == 0;
    for (const auto& [ring, xyz] : deposits_.all()) sky_.add(ring, xyz, firstHalf);
  }
  return seen;
}

void RadialFilm::merge(PathTally& fromThread) {
  auto& other = dynamic_cast<RadialFilm&>(fromThread);
  sky_.merge(other.sky_);
  tally_.info.intercepted += other.intercepted_;
  tally_.info.undeviated += other.undeviated_;
}

}  // namespace parhelion
