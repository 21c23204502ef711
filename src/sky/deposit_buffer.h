// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "sky/tally.h"

namespace parhelion {

/// The deposits of one thread on their way into a tally that several threads share, or into one for each layer.
///
/// Deposits are gathered by bands of the picture. Once a band's buffer is full, all its deposits are added in one go
/// under the band's lock. Their pixels are fetched into the cache ahead, whereas single deposits would each wait for
/// memory. Sums are exact integers, so the order of adding leaves no trace.
class DepositBuffer {
 public:
  /// The locks that all buffers of the same tallies share, one for each band.
  class Locks {
    friend DepositBuffer;
    static constexpr int kBands = 64;
    std::array<std::mutex, kBands> bands_;
  };

  /// Tallies of one camera, which must outlive the buffer: one for each layer, and SkyTally::Shared, which may be null
  /// for a single layer. Nobody may add to them but buffers with the same `locks`.
  DepositBuffer(std::vector<Tally*> layers, Tally* shared, std::shared_ptr<Locks> locks);
  DepositBuffer(Tally& tally, std::shared_ptr<Locks> locks)
      : DepositBuffer(std::vector{&tally}, nullptr, std::move(locks)) {}

  /// Like Tally::add(). The deposit reaches the tally at the next flush() at the latest.
  void add(int layer, int pixel, const FixedLight& light, bool firstHalf) {
    push({light, pixel, static_cast<short>(layer), firstHalf});
  }
  void add(int pixel, const FixedLight& light, bool firstHalf) { add(0, pixel, light, firstHalf); }

  /// Says that `hits` + 1 deposits of the same bundle, in as many layers of a pixel, are one without layers, with a
  /// square that is so much more than theirs.
  void addShared(int pixel, std::int64_t squares, std::int64_t hits) {
    push({{hits, squares, 0}, pixel, kShared, false});
  }

  /// Adds to the tallies what is still in the buffer.
  void flush();

 private:
  static constexpr int kRoom = 64;
  static constexpr short kShared = -1;
  struct Deposit {
    FixedLight light;  // of kShared: y is squares, x is hits
    int pixel;
    short layer;
    bool firstHalf;
  };
  struct Band {
    std::array<Deposit, kRoom> deposits;
    int count = 0;
  };
  void push(const Deposit& deposit) {
    const int band = deposit.pixel >> bandShift_;
    Band& b = bands_[static_cast<std::size_t>(band)];
    b.deposits[static_cast<std::size_t>(b.count++)] = deposit;
    if (b.count == kRoom) flush(band);
  }
  void flush(int band);
  template <class TallyOf>
  void flush(int band, const TallyOf& tallyOf);

  std::vector<Tally*> layers_;
  Tally* shared_;
  std::shared_ptr<Locks> locks_;
  int bandShift_ = 0;  // pixel >> bandShift_ is the pixel's band
  std::vector<Band> bands_;
};

}  // namespace parhelion
