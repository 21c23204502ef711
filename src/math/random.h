// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace parhelion {

/// Philox4x32 with ten rounds: a keyed permutation of 128-bit counters, four independent 32-bit words a call.
/// Salmon, Moraes, Dror & Shaw 2011, "Parallel random numbers: as easy as 1, 2, 3".
std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

/// 64 random bits to a number strictly inside (0, 1), the centre of one of 2^52 equal cells.
inline double toUnitInterval(std::uint64_t bits) { return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52; }

/// What a ray's random numbers are spent on; each purpose has a stream of its own.
enum class RandomPurpose : std::uint32_t { incidence = 0, path = 1, pilot = 2 };

/// The random numbers of one ray for one purpose: a pure function of (seed, ray index, purpose, position).
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t rayIndex, RandomPurpose purpose)
      : seed_(seed), ray_(rayIndex), purpose_(purpose) {}

  /// The next number, strictly inside (0, 1).
  double next() {
    if (used_ == 2) refill();
    return words_[used_++];
  }

 private:
  void refill();

  std::uint64_t seed_;
  std::uint64_t ray_;
  RandomPurpose purpose_;
  std::uint32_t block_ = 0;
  int used_ = 2;
  std::array<double, 2> words_{};
};

}  // namespace parhelion
