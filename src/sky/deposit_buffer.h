// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "sky/tally.h"

namespace parhelion {

/// The deposits of one thread on their way into a tally that several threads share.
///
/// Deposits are gathered by bands of the picture. Once a band's buffer is full, all its deposits are added in one go
/// under the band's lock. Their pixels are fetched into the cache ahead, whereas single deposits would each wait for
/// memory. Sums are exact integers, so the order of adding leaves no trace.
class DepositBuffer {
 public:
  /// The locks that all buffers of one tally share, one for each band.
  class Locks {
    friend DepositBuffer;
    static constexpr int kBands = 64;
    std::array<std::mutex, kBands> bands_;
  };

  /// `tally` must outlive the buffer. Nobody may add to it but buffers with the same `locks`.
  DepositBuffer(Tally& tally, std::shared_ptr<Locks> locks);

  /// Like Tally::add(). The deposit reaches the tally at the next flush() at the latest.
  void add(int pixel, const Vec3& xyz, bool firstHalf) {
    const int band = pixel >> bandShift_;
    Band& b = bands_[band];
    b.deposits[b.count++] = {xyz, pixel, firstHalf};
    if (b.count == kRoom) flush(band);
  }

  /// Adds to the tally what is still in the buffer.
  void flush();

 private:
  static constexpr int kRoom = 64;
  struct Deposit {
    Vec3 xyz;
    int pixel;
    bool firstHalf;
  };
  struct Band {
    std::array<Deposit, kRoom> deposits;
    int count = 0;
  };
  void flush(int band);

  Tally& tally_;
  std::shared_ptr<Locks> locks_;
  int bandShift_ = 0;  // pixel >> bandShift_ is the pixel's band
  std::vector<Band> bands_;
};

}  // namespace parhelion
