// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "math/lanes.h"

namespace parhelion {

inline std::uint32_t lowWord(std::uint64_t x) { return static_cast<std::uint32_t>(x); }
inline std::uint32_t highWord(std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); }

/// Philox4x32 with ten rounds: a keyed permutation of 128-bit counters. Each call gives four independent 32-bit words.
/// Salmon, Moraes, Dror & Shaw 2011, "Parallel random numbers: as easy as 1, 2, 3".
inline std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
  constexpr int kRounds = 10;
  constexpr std::uint64_t kMultiplier0 = 0xD2511F53, kMultiplier1 = 0xCD9E8D57;
  constexpr std::uint32_t kWeyl0 = 0x9E3779B9, kWeyl1 = 0xBB67AE85;
  for (int round = 0; round < kRounds; ++round) {
    const std::uint64_t product0 = kMultiplier0 * counter[0];
    const std::uint64_t product1 = kMultiplier1 * counter[2];
    counter = {highWord(product1) ^ counter[1] ^ key[0], lowWord(product1), highWord(product0) ^ counter[3] ^ key[1],
               lowWord(product0)};
    key[0] += kWeyl0;
    key[1] += kWeyl1;
  }
  return counter;
}

/// Turns 64 random bits into a number strictly inside (0, 1). The number is the centre of one of 2^52 equal cells,
/// which the upper 52 bits choose.
template <class T = double>
PARHELION_INLINE T toUnitInterval(const WordsOf<T>& bits) {
  // As the mantissa of a double with the exponent of 1, the 52 bits are a number in [1, 2).
  constexpr std::uint64_t kOne = 0x3FF0000000000000;
  return bitsAs<T>((bits >> 12) | kOne) - (1.0 - 0x1p-53);
}

/// What random numbers are used for. Each purpose has a stream of its own.
enum class RandomPurpose : std::uint32_t { incidence = 0, path = 1, pilot = 2, population = 3 };

/// The random numbers that decide which way light goes at the faces a path meets. The generator is xorshift128+ (Vigna
/// 2017, "Further scramblings of Marsaglia's xorshift generators"). For each bundle of rays it starts from 128 bits of
/// Philox.
template <class T>
struct PathRandom {
  WordsOf<T> state0, state1;

  /// The next number, strictly inside (0, 1).
  PARHELION_INLINE T next() {
    WordsOf<T> a = state0;
    const WordsOf<T> b = state1;
    const T number = toUnitInterval<T>(a + b);
    a ^= a << 23;
    state0 = b;
    state1 = a ^ b ^ (a >> 18) ^ (b >> 5);
    return number;
  }
};

/// The generator at the start of a bundle's paths.
inline PathRandom<double> pathRandom(std::uint64_t seed, std::uint64_t bundle) {
  const auto words = philox4x32({0, static_cast<std::uint32_t>(RandomPurpose::path), lowWord(bundle), highWord(bundle)},
                                {lowWord(seed), highWord(seed)});
  return {std::uint64_t{words[1]} << 32 | words[0], std::uint64_t{words[3]} << 32 | words[2]};
}

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
  void refill() {
    const auto words = philox4x32({block_++, static_cast<std::uint32_t>(purpose_), lowWord(ray_), highWord(ray_)},
                                  {lowWord(seed_), highWord(seed_)});
    words_[0] = toUnitInterval(std::uint64_t{words[1]} << 32 | words[0]);
    words_[1] = toUnitInterval(std::uint64_t{words[3]} << 32 | words[2]);
    used_ = 0;
  }

  std::uint64_t seed_;
  std::uint64_t ray_;
  RandomPurpose purpose_;
  std::uint32_t block_ = 0;
  int used_ = 2;
  std::array<double, 2> words_{};
};

}  // namespace parhelion
