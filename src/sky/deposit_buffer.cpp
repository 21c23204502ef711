// SPDX-License-Identifier: Apache-2.0
#include "sky/deposit_buffer.h"

#include <utility>

namespace parhelion {

DepositBuffer::DepositBuffer(Tally& tally, std::shared_ptr<Locks> locks)
    : tally_(tally), locks_(std::move(locks)), bands_(Locks::kBands) {
  while ((tally.pixels() - 1) >> bandShift_ >= Locks::kBands) ++bandShift_;
}

void DepositBuffer::flush() {
  for (int band = 0; band < Locks::kBands; ++band) flush(band);
}

void DepositBuffer::flush(int band) {
  // Some dozen loads may be under way at a time.
  constexpr int kAhead = 12;
  Band& b = bands_[band];
  const std::scoped_lock lock(locks_->bands_[band]);
  for (int i = 0; i < b.count; ++i) {
    if (i + kAhead < b.count) tally_.prefetch(b.deposits[i + kAhead].pixel);
    const Deposit& d = b.deposits[i];
    tally_.addExclusively(d.pixel, d.xyz, d.firstHalf);
  }
  b.count = 0;
}

}  // namespace parhelion
