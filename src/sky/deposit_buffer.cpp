// SPDX-License-Identifier: Apache-2.0
#include "sky/deposit_buffer.h"

#include <utility>

namespace parhelion {

DepositBuffer::DepositBuffer(std::vector<Tally*> layers, Tally* shared, std::shared_ptr<Locks> locks)
    : layers_(std::move(layers)), shared_(shared), locks_(std::move(locks)), bands_(Locks::kBands) {
  while ((layers_.front()->pixels() - 1) >> bandShift_ >= Locks::kBands) ++bandShift_;
}

void DepositBuffer::flush() {
  for (int band = 0; band < Locks::kBands; ++band) flush(band);
}

void DepositBuffer::flush(int band) {
  if (layers_.size() == 1 && !shared_)
    flush(band, [&only = *layers_.front()](const Deposit&) -> Tally& { return only; });
  else
    flush(band, [this](const Deposit& d) -> Tally& { return d.layer == kShared ? *shared_ : *layers_[d.layer]; });
}

template <class TallyOf>
void DepositBuffer::flush(int band, const TallyOf& tallyOf) {
  // Some dozen loads may be under way at a time.
  constexpr int kAhead = 12;
  Band& b = bands_[static_cast<std::size_t>(band)];
  const std::scoped_lock lock(locks_->bands_[static_cast<std::size_t>(band)]);
  for (int i = 0; i < b.count; ++i) {
    if (i + kAhead < b.count) {
      const Deposit& ahead = b.deposits[static_cast<std::size_t>(i + kAhead)];
      tallyOf(ahead).prefetch(ahead.pixel);
    }
    const Deposit& d = b.deposits[static_cast<std::size_t>(i)];
    if (d.layer == kShared)
      tallyOf(d).addShared(d.pixel, d.light.y, d.light.x);
    else
      tallyOf(d).addExclusively(d.pixel, d.light, d.firstHalf);
  }
  b.count = 0;
}

}  // namespace parhelion
