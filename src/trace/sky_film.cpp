// SPDX-License-Identifier: Apache-2.0
#include "trace/sky_film.h"

namespace parhelion {

int SkyFilm::add(const TracedRays& traced) {
  const auto& [queue, exits, members, mesh, kernels] = traced;
  byBundle_.sort(queue, exits);
  const int views = mirrored_ ? 2 : 1;
  for (int view = 0; view < views; ++view) {
    pixel_[view].resize(exits.count + RayQueue::kSpare);
    kernels.pixels(camera_, view == 1, exits, pixel_[view].data());
  }

  int seen = 0;
  for (int place = 0; place < queue.count; ++place) {
    for (int member = 0; member < members; ++member)
      intercepted_ += views * toFixed(queue.weight[place] * queue.light[queue.ray(member, place)].light);
    deposits_.clear();
    for (int i = byBundle_.begin(place); i < byBundle_.begin(place + 1); ++i) {
      const int exit = byBundle_.exit(i);
      const SpectralSample& light = queue.light[static_cast<int>(exits.ray[exit])];
      if (exits.undeviated[exit] != 0.0) undeviated_ += views * toFixed(exits.energy[exit] * light.light);
      for (int view = 0; view < views; ++view)
        if (pixel_[view][exit] >= 0) deposits_.add(pixel_[view][exit], exits.energy[exit] * light.xyz), ++seen;
    }
    const bool firstHalf = queue.bundle[place] % 2 == 0;
    for (const auto& [pixel, xyz] : deposits_.all()) buffer_.add(pixel, xyz, firstHalf);
  }
  return seen;
}

void SkyFilm::merge(PathTally& fromThread) {
  auto& other = dynamic_cast<SkyFilm&>(fromThread);
  other.buffer_.flush();
  tally_.info.intercepted += other.intercepted_;
  tally_.info.undeviated += other.undeviated_;
}

}  // namespace parhelion
