// SPDX-License-Identifier: Apache-2.0
#include "sky/deposit_buffer.h"

#include <algorithm>
#include <span>
#include <utility>

namespace parhelion {

DepositBuffer::DepositBuffer(std::vector<Tally*> layers, Tally* shared, std::shared_ptr<Locks> locks)
    : layers_(std::move(layers)), shared_(shared), locks_(std::move(locks)), bands_(Locks::kBands) {
  while ((layers_.front()->pixels() - 1) >> bandShift_ >= Locks::kBands) ++bandShift_;
}

void DepositBuffer::flush() {
  for (Band& band : bands_) flush(band);
}

void DepositBuffer::makeRoom(Band& band, std::uint64_t bundle) {
  if (band.empty() || band.back().bundle == bundle)
    band.reserve(std::max(kRoom, 2 * band.size()));
  else
    flush(band);
}

void DepositBuffer::flush(Band& band) {
  const std::scoped_lock lock(locks_->bands_[static_cast<std::size_t>(&band - bands_.data())]);
  const std::span<const Deposit> deposits = band;
  const auto forAll = [deposits](const auto& tallyOf, const auto& add) {
    // Some dozen loads may be under way at a time.
    constexpr std::size_t kAhead = 12;
    for (std::size_t i = 0; i < deposits.size(); ++i) {
      if (i + kAhead < deposits.size()) tallyOf(deposits[i + kAhead]).prefetch(deposits[i + kAhead].pixel);
      add(tallyOf(deposits[i]), deposits[i]);
    }
  };
  const auto addLight = [](Tally& tally, const Deposit& d) {
    tally.addExclusively(d.pixel, d.light, d.bundle % 2 == 0);
  };
  if (layers_.size() == 1 && !shared_) {
    forAll([&only = *layers_.front()](const Deposit&) -> Tally& { return only; }, addLight);
  } else {
    forAll([this](const Deposit& d) -> Tally& { return d.layer == kShared ? *shared_ : *layers_[d.layer]; },
           [&](Tally& tally, const Deposit& d) {
             if (d.layer == kShared)
               tally.addShared(d.pixel, d.light.y, d.light.x);
             else
               addLight(tally, d);
           });
  }
  band.clear();
}

}  // namespace parhelion
