// SPDX-License-Identifier: Apache-2.0
#include "trace/sky_film.h"

#include <algorithm>
#include <cassert>
#include <type_traits>

namespace parhelion {

SkyFilm::SkyFilm(std::vector<Tally*> layers, Tally* shared, std::shared_ptr<DepositBuffer::Locks> locks)
    : layers_(std::move(layers)),
      shared_(shared),
      mirrored_(layers_.front()->info.symmetry == TallySymmetry::mirror),
      camera_(layers_.front()->info.camera),
      view_(camera_),
      locks_(std::move(locks)),
      buffer_(layers_, shared_, locks_),
      folded_(foldsPicture() && !layers_.front()->info.rays.empty()) {}

int SkyFilm::add(const TracedRays& traced) {
  const auto& [queue, exits, members, population, mesh, steps] = traced;
  const std::size_t room = static_cast<std::size_t>(exits.count + RayQueue::kSpare);
  if (seen_.exit.size() < room)
    for (auto* row : {&seen_.exit, &seen_.ray, &seen_.pixel, &seen_.mirroredPixel}) row->resize(room);
  steps.see(view_, showsBothViews(), exits, seen_);

  byBundle_.sort(queue, seen_.ray, seen_.count);
  const int views = layers_.size() > 1 ? deposit(traced, layeredDeposits_) : deposit(traced, plainDeposits_);
  return foldsPicture() ? 2 * views : views;
}

template <class Deposits>
int SkyFilm::deposit(const TracedRays& traced, Deposits& deposits) {
  constexpr bool kIsLayered = std::is_same_v<Deposits, LayeredDeposits>;
  const RayQueue& queue = traced.queue;
  const ExitList& exits = traced.exits;
  const Vec3 perWhite = layers_.front()->perWhite();
  const bool bothViews = showsBothViews();
  int views = 0;
  for (int place = 0; place < queue.count; ++place) {
    const int begin = byBundle_.begin(place), end = byBundle_.begin(place + 1);
    if (begin == end) continue;
    deposits.clear();
    for (int i = begin; i < end; ++i) {
      const int item = byBundle_.item(i), exit = static_cast<int>(seen_.exit[item]);
      const Pixels pixels{static_cast<int>(seen_.pixel[item]),
                          bothViews ? static_cast<int>(seen_.mirroredPixel[item]) : Pixels::kNowhere};
      const Vec3& xyz = queue.light[static_cast<int>(seen_.ray[item])].xyz;
      const FixedLight light = toFixedLight(exits.energy[exit] * xyz, perWhite);
      views += pixels.count();
      if constexpr (kIsLayered)
        pixels.forEach([&](int pixel) { deposits.add(pixel, exits.layer[static_cast<std::size_t>(exit)], light); });
      else
        deposits.add(pixels, light);
    }
    const std::uint64_t bundle = queue.bundle[place];
    if constexpr (kIsLayered) {
      for (const auto& [pixel, layer, light] : deposits.all()) buffer_.add(layer, pixel, light, bundle);
      deposits.forShared([this, bundle](int pixel, std::int64_t squares, std::int64_t hits) {
        buffer_.addShared(pixel, squares, hits, bundle);
      });
    } else {
      // Two exits may share one pixel and not the other: the buffer makes one deposit of what falls into the same.
      for (const auto& deposit : deposits.all())
        deposit.bin.forEach([&](int pixel) { buffer_.add(pixel, deposit.light, bundle); });
    }
  }
  return views;
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

double SkyFilm::fullnessAtMost() const {
  constexpr double kMostByMirrors = 4.0;  // the squares of the middle column
  return fullness() * (foldsPicture() && !folded_ ? kMostByMirrors : 1.0);
}

void SkyFilm::visitSums(SumVisitor& visitor) {
  forAll([&](Tally& tally) { visitor.visit(tally.sums()); });
}

}  // namespace parhelion
