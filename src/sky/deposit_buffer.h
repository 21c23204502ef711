// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "sky/tally.h"

namespace parhelion {

/// One thread's deposits on their way into a tally that threads share. They are gathered by bands of the picture; a
/// full band is added in one go under the band's lock, the pixels fetched ahead, where single deposits would each wait
/// for memory. Sums are exact integers, so the order leaves no trace.
class DepositBuffer {
 public:
  /// What the threads of one tally share.
  class Locks {
    friend DepositBuffer;
    static constexpr int kBands = 64;
    std::array<std::mutex, kBands> bands_;
  };

  /// `tally` must outlive the buffer; nobody may add to it but by buffers with the same `locks`.
  DepositBuffer(Tally& tally, std::shared_ptr<Locks> locks);

  /// As Tally::add(), at some time until flush().
  void add(int pixel, const Vec3& xyz, bool firstHalf) {
    const int band = pixel >> bandShift_;
    Band& b = bands_[band];
    b.deposits[b.count++] = {xyz, pixel, firstHalf};
    if (b.count == kRoom) flush(band);
  }

  /// Adds all that is still on its way.
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
