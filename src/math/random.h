// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "math/lanes.h"

namespace parhelion {

inline std::uint32_t lowWord(std::uint64_t x) { return static_cast<std::uint32_t>(x); }
inline std::uint32_t highWord(std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); }
inline std::uint64_t fromWords(std::uint32_t high, std::uint32_t low) { return std::uint64_t{high} << 32 | low; }

/// A block of Philox: four words of 32 bits. Each is in the lower half of 64 bits. The upper halves mean nothing.
template <class Words>
struct PhiloxBlock {
  Words a, b, c, d;
};

/// Philox4x32 with ten rounds: a keyed permutation of 128-bit counters. Each call gives four independent 32-bit words.
/// `Words` is std::uint64_t, or lanes of it. Salmon, Moraes, Dror & Shaw 2011, "Parallel random numbers: as easy as
/// 1, 2, 3".
template <class Words>
PARHELION_INLINE PhiloxBlock<Words> philox(const PhiloxBlock<Words>& counter, std::uint64_t key) {
  constexpr int kRounds = 10;
  constexpr std::uint32_t kMultiplier0 = 0xD2511F53, kMultiplier1 = 0xCD9E8D57;
  constexpr std::uint32_t kWeyl0 = 0x9E3779B9, kWeyl1 = 0xBB67AE85;
  auto [a, b, c, d] = counter;
  std::uint32_t key0 = lowWord(key), key1 = highWord(key);
  for (int round = 0; round < kRounds; ++round) {
    const Words product0 = product32(a, kMultiplier0), product1 = product32(c, kMultiplier1);
    a = (product1 >> 32) ^ b ^ key0;
    b = product1;
    c = (product0 >> 32) ^ d ^ key1;
    d = product0;
    key0 += kWeyl0;
    key1 += kWeyl1;
  }
  return {a, b, c, d};
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
enum class RandomPurpose : std::uint32_t {
  incidence = 0,
  path = 1,
  pilot = 2,
  population = 3,
  walk = 4,
  shape = 5,
  size = 6
};

/// Two words of 64 random bits.
template <class Words>
struct RandomWords {
  Words first, second;
};

/// Two words that depend on the arguments alone. `ray` is the index of a ray or of a bundle of rays. Blocks are
/// independent of each other.
template <class Words>
PARHELION_INLINE RandomWords<Words> randomWords(std::uint64_t seed, RandomPurpose purpose, std::uint32_t block,
                                                const Words& ray) {
  const Words zero{};
  const PhiloxBlock<Words> counter{zero + std::uint64_t{block}, zero + static_cast<std::uint64_t>(purpose), ray,
                                   ray >> 32};
  const PhiloxBlock<Words> w = philox(counter, seed);
  constexpr std::uint64_t kLow = 0xFFFFFFFF;
  return {(w.b << 32) | (w.a & kLow), (w.d << 32) | (w.c & kLow)};
}

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
template <class T>
PARHELION_INLINE PathRandom<T> pathRandom(std::uint64_t seed, const WordsOf<T>& bundle) {
  const RandomWords<WordsOf<T>> start = randomWords<WordsOf<T>>(seed, RandomPurpose::path, 0, bundle);
  return {start.first, start.second};
}

}  // namespace parhelion
