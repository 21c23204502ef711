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
  for (Band& band : bands_) flush(band, band.size());
}

std::size_t DepositBuffer::room() const {
  std::size_t room = 0;
  for (const Band& band : bands_) room += band.capacity();
  return room;
}

void DepositBuffer::makeRoom(Band& band, std::uint64_t bundle) {
  const auto isOther = [bundle](const Deposit& d) { return d.bundle != bundle; };
  const auto ofOthers =
      static_cast<std::size_t>(std::find_if(band.rbegin(), band.rend(), isOther).base() - band.begin());
  // A buffer that grew whenever the last bundle goes on would grow as long as a run lasts.
  if (ofOthers > 0)
    flush(band, ofOthers);
  else
    band.reserve(std::max(kRoom, 2 * band.size()));
}

void DepositBuffer::flush(Band& band, std::size_t count) {
  const std::scoped_lock lock(locks_->bands_[static_cast<std::size_t>(&band - bands_.data())]);
  const std::span<const Deposit> deposits(band.data(), count);
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
  band.erase(band.begin(), band.begin() + static_cast<std::ptrdiff_t>(count));
}

}  // namespace parhelion
