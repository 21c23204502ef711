// SPDX-License-Identifier: Apache-2.0
#include "trace/sky_film.h"

#include <cassert>

namespace parhelion {

int SkyFilm::add(const TracedRays& traced) {
  const auto& [queue, exits, members, population, mesh, steps] = traced;
  const bool bothViews = mirrored_ && !foldsPicture();
  const std::size_t room = static_cast<std::size_t>(2 * exits.count + RayQueue::kSpare);
  if (seen_.pixel.size() < room)
    for (auto* row : {&seen_.pixel, &seen_.energy, &seen_.ray}) row->resize(room);
  seen_.count = 0;
  steps.see(camera_, false, exits, seen_);
  if (bothViews) steps.see(camera_, true, exits, seen_);

  intercepted_.add(traced);
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

void SkyFilm::merge(Film& fromThread) {
  auto& other = dynamic_cast<SkyFilm&>(fromThread);
  other.buffer_.flush();
  other.intercepted_.moveTo(tally_.info);
}

void SkyFilm::finish() {
  if (!foldsPicture()) return;
  assert(!folded_);
  tally_.addMirrorImage();
  folded_ = true;
}

void SkyFilm::reopen() {
  if (!foldsPicture()) return;
  assert(folded_);
  tally_.removeMirrorImage();
  folded_ = false;
}

void SkyFilm::visitSums(SumVisitor& visitor) {
  visitor.visit(tally_.sums());
  tally_.info.visitTotals(visitor);
}

}  // namespace parhelion
