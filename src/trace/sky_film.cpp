// SPDX-License-Identifier: Apache-2.0
#include "trace/sky_film.h"

namespace parhelion {

void SkyFilm::add(const TracedRays& traced) {
  const auto& [queue, exits, members, mesh, kernels] = traced;
  pixel_.resize(exits.count + RayQueue::kSpare);
  kernels.pixels(camera_, exits, pixel_.data());
  byBundle_.sort(queue, exits);
  for (int place = 0; place < queue.count; ++place) {
    for (int member = 0; member < members; ++member)
      intercepted_ += toFixed(queue.weight[place] * queue.light[queue.ray(member, place)].light);
    deposits_.clear();
    for (int i = byBundle_.begin(place); i < byBundle_.begin(place + 1); ++i) {
      const int exit = byBundle_.exit(i);
      const SpectralSample& light = queue.light[static_cast<int>(exits.ray[exit])];
      if (exits.undeviated[exit] != 0.0)
        undeviated_ += toFixed(exits.energy[exit] * light.light);
      else if (pixel_[exit] >= 0)
        deposits_.add(pixel_[exit], exits.energy[exit] * light.xyz);
    }
    const bool firstHalf = queue.bundle[place] % 2 == 0;
    for (const auto& [pixel, xyz] : deposits_.all()) buffer_.add(pixel, xyz, firstHalf);
  }
}

void SkyFilm::merge(PathTally& fromThread) {
  auto& other = dynamic_cast<SkyFilm&>(fromThread);
  other.buffer_.flush();
  tally_.info.intercepted += other.intercepted_;
  tally_.info.undeviated += other.undeviated_;
}

}  // namespace parhelion
