// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
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

  /// Adds light of a bundle to a pixel, like Tally::add(). What the bundle has brought there before becomes one deposit
  /// with it, unless the light of another bundle came in between. It reaches the tally at the next flush() at the
  /// latest.
  void add(int layer, int pixel, const FixedLight& light, std::uint64_t bundle) {
    Band& band = bandOf(pixel);
    for (auto d = band.rbegin(); d != band.rend() && d->bundle == bundle; ++d)
      if (d->pixel == pixel && d->layer == layer) {
        d->light += light;
        return;
      }
    push(band, {light, bundle, pixel, layer});
  }
  void add(int pixel, const FixedLight& light, std::uint64_t bundle) { add(0, pixel, light, bundle); }

  /// Says that `hits` + 1 deposits of the same bundle, in as many layers of a pixel, are one without layers, with a
  /// square that is so much more than theirs.
  void addShared(int pixel, std::int64_t squares, std::int64_t hits, std::uint64_t bundle) {
    push(bandOf(pixel), {{hits, squares, 0}, bundle, pixel, kShared});
  }

  /// Adds to the tallies what is still in the buffer.
  void flush();

  /// Of all deposits that it has memory for.
  std::size_t room() const;

 private:
  static constexpr std::size_t kRoom = 64;  // of a band, more where a single bundle needs it
  static constexpr int kShared = -1;
  struct Deposit {
    FixedLight light;  // of kShared: y is squares, x is hits
    std::uint64_t bundle;
    int pixel, layer;
  };
  using Band = std::vector<Deposit>;

  Band& bandOf(int pixel) { return bands_[static_cast<std::size_t>(pixel >> bandShift_)]; }
  void push(Band& band, const Deposit& deposit) {
    if (band.size() == band.capacity()) makeRoom(band, deposit.bundle);
    band.push_back(deposit);
  }
  /// For a deposit of this bundle: the others of the same must stay, if there are some.
  void makeRoom(Band& band, std::uint64_t bundle);
  /// Adds the first `count` deposits of a band to the tallies.
  void flush(Band& band, std::size_t count);

  std::vector<Tally*> layers_;
  Tally* shared_;
  std::shared_ptr<Locks> locks_;
  int bandShift_ = 0;
  std::vector<Band> bands_;
};

}  // namespace parhelion
