// SPDX-License-Identifier: Apache-2.0
#include "beam/band_store.h"

#include <algorithm>
#include <utility>

namespace parhelion {

namespace {

// More rings on either side, of all of them, and more orders, for the pictures to come.
constexpr int kMoreRings = 8;
constexpr double kMoreOrders = 1.5;

void widen(BandMesh& mesh) {
  mesh.first = std::max(mesh.first - mesh.rings / kMoreRings, 0);
  mesh.end = std::min(mesh.end + mesh.rings / kMoreRings, mesh.rings);
  mesh.orders *= kMoreOrders;
}

}  // namespace

BandStore::Bands::Bands(BandStore& store, BandKind kind)
    : store_(store),
      kind_(std::move(kind)),
      cosines_(store.cosines(kind_.mesh.cells)),
      table_(kind_.prisms, kind_.indices, kind_.columns, kind_.mesh.bands, kind_.cutShare, kind_.wanted),
      light_(table_, *cosines_, kind_.mesh, kind_.colours, kind_.lights, kind_.fewLights) {}

void BandStore::Bands::forEach(std::span<const int> numbers,
                               const std::function<void(std::span<const NumberedBand>)>& take) {
  const double thick = 0.5 * kPi / kind_.mesh.bands;
  std::vector<int> missing;
  for (const int number : numbers)
    if (!kept_.contains(number)) missing.push_back(number);
  if (!missing.empty()) table_.prepare(missing.front() * thick, (missing.back() + 1) * thick);
  for (std::size_t first = 0; first < numbers.size(); first += kAtOnce) {
    const std::span<const int> some = numbers.subspan(first, std::min(kAtOnce, numbers.size() - first));
    missing.clear();
    for (const int number : some)
      if (!kept_.contains(number)) missing.push_back(number);
    // Memory that is there already comes first.
    std::ranges::stable_partition(made_, [](const BandLight::Band& band) { return !band.lit.empty(); });
    made_.resize(std::max(made_.size(), missing.size()));
    light_.make(missing, made_);
    std::vector<NumberedBand> bands;
    std::size_t next = 0;
    for (const int number : some) {
      const auto kept = kept_.find(number);
      if (kept != kept_.end()) kept->second.lastPicture = store_.picture_;
      bands.push_back({number, kept != kept_.end() ? &kept->second.band : &made_[next++]});
    }
    take(bands);
    for (std::size_t k = 0; k < missing.size(); ++k) {
      if (store_.held_ + bytesEach() > store_.mostBytes_) break;
      store_.held_ += bytesEach();
      kept_.emplace(missing[k], Kept{std::exchange(made_[k], {}), store_.picture_});
    }
  }
}

/// Drops bands that no picture since that one has used. The memory of some is for the next to be made.
void BandStore::Bands::drop(long beforePicture) {
  std::erase_if(made_, [](const BandLight::Band& band) { return band.lit.empty(); });
  for (auto one = kept_.begin(); one != kept_.end();) {
    if (one->second.lastPicture >= beforePicture) {
      ++one;
      continue;
    }
    store_.held_ -= bytesEach();
    if (made_.size() < kAtOnce) made_.push_back(std::move(one->second.band));
    one = kept_.erase(one);
  }
}

void BandStore::startPicture() {
  ++picture_;
  for (const auto& kind : kinds_) kind->drop(picture_ - 1);
  std::erase_if(kinds_, [&](const auto& kind) { return kind->lastPicture_ < picture_ - 1; });
}

std::shared_ptr<const CosineTable> BandStore::cosines(int cells) {
  std::weak_ptr<const CosineTable>& kept = cosines_[cells];
  std::shared_ptr<const CosineTable> table = kept.lock();
  if (!table) kept = table = std::make_shared<const CosineTable>(cells);
  return table;
}

std::shared_ptr<const PixelDirections> BandStore::directions(const Camera& camera) {
  if (!directions_ || directions_->camera().settings() != camera.settings())
    directions_ = std::make_shared<const PixelDirections>(camera);
  return directions_;
}

std::vector<double> BandStore::solidAngles(const Camera& camera) const {
  const bool isKept = directions_ && directions_->camera().settings() == camera.settings();
  return isKept ? directions_->solidAngles() : camera.solidAngles();
}

BandStore::Bands& BandStore::open(const BandKind& kind) {
  const auto found = std::ranges::find_if(kinds_, [&](const auto& one) { return one->kind_.covers(kind); });
  Bands* bands = found != kinds_.end() ? found->get() : nullptr;
  if (!bands) {
    BandKind made = kind;
    if (mostBytes_ == 0)
      kinds_.clear();
    else
      widen(made.mesh);
    bands = kinds_.emplace_back(std::unique_ptr<Bands>(new Bands(*this, made))).get();
  }
  bands->lastPicture_ = picture_;
  return *bands;
}

}  // namespace parhelion
