// SPDX-License-Identifier: Apache-2.0
#include "trace/sky_film.h"

namespace parhelion {

int SkyFilm::add(const TracedRays& traced) {
  const auto& [queue, exits, members, mesh, steps] = traced;
  const bool bothViews = mirrored_ && !foldsPicture();
  const std::size_t room = static_cast<std::size_t>(2 * exits.count + RayQueue::kSpare);
  if (seen_.pixel.size() < room)
    for (auto* row : {&seen_.pixel, &seen_.energy, &seen_.ray}) row->resize(room);
  seen_.count = 0;
  steps.see(camera_, false, exits, seen_);
  if (bothViews) steps.see(camera_, true, exits, seen_);

  countStraight(traced);
  byBundle_.sort(queue, seen_.ray, seen_.count);
  for (int place = 0; place < queue.count; ++place) {
    deposits_.clear();
    for (int i = byBundle_.begin(place); i < byBundle_.begin(place + 1); ++i) {
      const int item = byBundle_.item(i);
      const Vec3& xyz = queue.light[static_cast<int>(seen_.ray[item])].xyz;
      deposits_.add(static_cast<int>(seen_.pixel[item]), seen_.energy[item] * xyz);
    }
    const bool firstHalf = queue.bundle[place] % 2 == 0;
    for (const auto& [pixel, xyz] : deposits_.all()) buffer_.add(pixel, xyz, firstHalf);
  }
  return foldsPicture() ? 2 * seen_.count : seen_.count;
}

/// Counts the light intercepted, and of that the light that goes straight on.
void SkyFilm::countStraight(const TracedRays& traced) {
  const auto& [queue, exits, members, mesh, steps] = traced;
  for (int member = 0; member < members; ++member)
    for (int place = 0; place < queue.count; ++place)
      intercepted_ += toFixed(queue.weight[place] * queue.light[queue.ray(member, place)].light);
  for (int exit = 0; exit < exits.count; ++exit)
    if (exits.undeviated[exit] != 0.0)
      undeviated_ += toFixed(exits.energy[exit] * queue.light[static_cast<int>(exits.ray[exit])].light);
}

void SkyFilm::merge(PathTally& fromThread) {
  auto& other = dynamic_cast<SkyFilm&>(fromThread);
  other.buffer_.flush();
  const int images = mirrored_ ? 2 : 1;
  tally_.info.intercepted += images * other.intercepted_;
  tally_.info.undeviated += images * other.undeviated_;
}

void SkyFilm::finish() {
  if (foldsPicture()) tally_.addMirrorImage();
}

}  // namespace parhelion
