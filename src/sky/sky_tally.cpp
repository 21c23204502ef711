// SPDX-License-Identifier: Apache-2.0
#include "sky/sky_tally.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace parhelion {

SkyTally::SkyTally(TallyInfo info, int colours, std::vector<TallySymmetry> symmetries,
                   const std::vector<std::string>& layers)
    : layers_(layers), symmetries_(std::move(symmetries)) {
  if (symmetries_.empty()) throw std::invalid_argument("tally: no symmetry, not even none");
  for (const TallySymmetry one : symmetries_)
    if (std::ranges::count(symmetries_, one) > 1) throw std::invalid_argument("tally: a symmetry is there twice");
  if (!layers_.empty()) layers_.emplace_back(kRestLayer);
  const auto empty = [&](TallySymmetry symmetry) {
    info.symmetry = symmetry;
    return Tally(info, colours);
  };
  // Growing would copy tallies, and take half as much memory again.
  parts_.reserve(std::max<std::size_t>(1, layers_.size()) * symmetries_.size());
  if (!layers_.empty()) shared_.reserve(symmetries_.size());
  for (const std::string& layer : layers_.empty() ? std::vector<std::string>{""} : layers_)
    for (const TallySymmetry symmetry : symmetries_) parts_.push_back({layer, empty(symmetry)});
  if (!layers_.empty())
    for (const TallySymmetry symmetry : symmetries_) shared_.push_back(empty(symmetry));
}

SkyTally::SkyTally(Tally whole) : symmetries_{whole.info.symmetry} { parts_.push_back({"", std::move(whole)}); }

std::vector<Tally*> SkyTally::all() {
  std::vector<Tally*> tallies;
  for (Part& part : parts_) tallies.push_back(&part.tally);
  for (Shared& shared : shared_) tallies.push_back(&shared);
  return tallies;
}

std::vector<const Tally*> SkyTally::all() const {
  std::vector<const Tally*> tallies;
  for (const Part& part : parts_) tallies.push_back(&part.tally);
  for (const Shared& shared : shared_) tallies.push_back(&shared);
  return tallies;
}

void SkyTally::shareOrigin() {
  const TallyOrigin& origin = info();
  for (Tally* tally : all())
    if (&tally->info != &info()) static_cast<TallyOrigin&>(tally->info) = origin;
}

Tally SkyTally::withoutLayers(std::size_t symmetry) const {
  Tally whole = parts_[symmetry].tally;
  if (layers_.empty()) return whole;
  for (std::size_t layer = 1; layer < layers_.size(); ++layer)
    whole.addPlaces(parts_[layer * symmetries_.size() + symmetry].tally);
  whole.takeAsOne(shared_[symmetry]);
  if (whole.rings()) whole.spreadRings();
  return whole;
}

Tally SkyTally::flattened() const {
  if (symmetries_.size() == 1) return withoutLayers(0);
  int images = 1;
  for (std::size_t i = 0; i < symmetries_.size(); ++i) images = std::max(images, parts_[i].tally.info.images());
  TallyInfo all = info();
  for (std::size_t i = 0; i < symmetries_.size(); ++i)
    if (parts_[i].tally.info.images() == images) all = parts_[i].tally.info;
  all.symmetry = images == 2 ? TallySymmetry::mirror : TallySymmetry::none;
  Tally flat(all, colours());
  for (std::size_t i = 0; i < symmetries_.size(); ++i) {
    const Tally part = withoutLayers(i);
    const std::int64_t times = images / part.info.images();
    for (int pixel = 0; pixel < flat.pixels(); ++pixel) {
      if (part.isDark(pixel)) continue;
      for (int slot = 0; slot < flat.slots(); ++slot) {
        std::int64_t sum = flat.raw(pixel, slot);
        const std::int64_t factor = slot == Tally::kHits ? 1 : slot == Tally::kSquares ? times * times : times;
        for (std::int64_t k = 0; k < factor; ++k) addFixed(sum, part.raw(pixel, slot));
        flat.setRaw(pixel, slot, sum);
      }
    }
  }
  return flat;
}

double SkyTally::fullness() const {
  double most = 0.0;
  for (const Tally* tally : all()) most = std::max(most, tally->fullness());
  return most;
}

void SkyTally::requireSameParts(const SkyTally& other) const {
  if (layers_ != other.layers_) throw std::invalid_argument("tally: their layers differ");
  if (symmetries_ != other.symmetries_) throw std::invalid_argument("tally: their symmetries differ");
}

void SkyTally::addSums(const SkyTally& other) {
  requireSameParts(other);
  const std::vector<Tally*> own = all();
  const std::vector<const Tally*> more = other.all();
  std::size_t added = 0;
  try {
    for (; added < own.size(); ++added) own[added]->addSums(*more[added]);
  } catch (...) {
    while (added-- > 0) own[added]->subtractSums(*more[added]);
    throw;
  }
}

void SkyTally::merge(const SkyTally& other) {
  addSums(other);
  spreadRings();
}

void SkyTally::spreadRings() {
  std::vector<RadialSky::Spreading> all;
  for (Part& part : parts_)
    if (part.tally.rings()) all.push_back({part.tally.rings(), &part.tally});
  RadialSky::spread(all);
}

void SkyTally::subtract(const SkyTally& other) {
  requireSameParts(other);
  const std::vector<Tally*> own = all();
  const std::vector<const Tally*> less = other.all();
  for (std::size_t i = 0; i < own.size(); ++i) own[i]->subtractSums(*less[i]);
  spreadRings();
}

bool SkyTally::operator==(const SkyTally& other) const {
  if (layers_ != other.layers_ || symmetries_ != other.symmetries_) return false;
  const std::vector<const Tally*> own = all(), others = other.all();
  return std::ranges::equal(own, others, [](const Tally* a, const Tally* b) { return *a == *b; });
}

}  // namespace parhelion
