// SPDX-License-Identifier: Apache-2.0
#include "trace/sky_film.h"

#include <algorithm>
#include <cassert>

namespace parhelion {

SkyFilm::SkyFilm(std::vector<Tally*> layers, Tally* shared, std::shared_ptr<DepositBuffer::Locks> locks)
    : layers_(std::move(layers)),
      shared_(shared),
      mirrored_(layers_.front()->info.symmetry == TallySymmetry::mirror),
      camera_(layers_.front()->info.camera),
      locks_(std::move(locks)),
      buffer_(layers_, shared_, locks_),
      folded_(foldsPicture() && !layers_.front()->info.rays.empty()) {}

int SkyFilm::add(const TracedRays& traced) {
  const auto& [queue, exits, members, population, mesh, steps] = traced;
  const bool bothViews = mirrored_ && !foldsPicture(), isLayered = layers_.size() > 1;
  const Vec3& perWhite = layers_.front()->perWhite();
  const std::size_t room = static_cast<std::size_t>(2 * exits.count + RayQueue::kSpare);
  if (seen_.pixel.size() < room)
    for (auto* row : {&seen_.pixel, &seen_.exit, &seen_.ray}) row->resize(room);
  seen_.count = 0;
  steps.see(camera_, false, exits, seen_);
  if (bothViews) steps.see(camera_, true, exits, seen_);

  byBundle_.sort(queue, seen_.ray, seen_.count);
  for (int place = 0; place < queue.count; ++place) {
    deposits_.clear();
    for (int i = byBundle_.begin(place); i < byBundle_.begin(place + 1); ++i) {
      const int item = byBundle_.item(i), exit = static_cast<int>(seen_.exit[item]);
      const Vec3& xyz = queue.light[static_cast<int>(seen_.ray[item])].xyz;
      deposits_.add(static_cast<int>(seen_.pixel[item]), isLayered ? exits.layer[static_cast<std::size_t>(exit)] : 0,
                    toFixedLight(exits.energy[exit] * xyz, perWhite));
    }
    const bool firstHalf = queue.bundle[place] % 2 == 0;
    for (const auto& [pixel, layer, light] : deposits_.all()) buffer_.add(layer, pixel, light, firstHalf);
    if (isLayered)
      deposits_.forShared(
          [this](int pixel, std::int64_t squares, std::int64_t hits) { buffer_.addShared(pixel, squares, hits); });
  }
  return foldsPicture() ? 2 * seen_.count : seen_.count;
}

void SkyFilm::merge(Film& fromThread) { dynamic_cast<SkyFilm&>(fromThread).buffer_.flush(); }

void SkyFilm::finish() {
  if (!foldsPicture()) return;
  assert(!folded_);
  forAll([](Tally& tally) { tally.addMirrorImage(); });
  folded_ = true;
}

void SkyFilm::reopen() {
  if (!foldsPicture()) return;
  assert(folded_);
  forAll([](Tally& tally) { tally.removeMirrorImage(); });
  folded_ = false;
}

double SkyFilm::fullness() const {
  double most = 0.0;
  forAll([&](const Tally& tally) { most = std::max(most, tally.fullness()); });
  return most;
}

void SkyFilm::visitSums(SumVisitor& visitor) {
  forAll([&](Tally& tally) { visitor.visit(tally.sums()); });
}

}  // namespace parhelion
