// SPDX-License-Identifier: Apache-2.0
#pragma once

// A coordinate in [0, 1) is kept as the word of its binary digits, the digit of weight 1/2 in the lowest bit. Carries
// of sums and products then run from heavier digits to lighter ones, as a nested scramble needs.

#include <array>
#include <cstdint>

namespace parhelion {

inline constexpr int kSobolDimensions = 32;

/// What each of the 16 values of each of the 8 groups of four index bits adds (XOR) to a coordinate's digits.
using SobolTable = std::array<std::array<std::uint32_t, 16>, 8>;

/// The generator matrices of Joe & Kuo 2008, one a dimension.
extern const std::array<SobolTable, kSobolDimensions> kSobolTables;

/// The digits of the Sobol' point `index` (plain binary order, not Gray code) in `dimension`, without scramble.
inline std::uint32_t sobolDigits(std::uint32_t index, int dimension) {
  const SobolTable& table = kSobolTables[dimension];
  std::uint32_t digits = 0;
  for (int group = 0; group < 8; ++group) digits ^= table[group][index >> 4 * group & 15];
  return digits;
}

/// Owen-scrambled Sobol' points in (0, 1)^32: a pure function of (seed, index, dimension). The first 2^32 indices are
/// one digital sequence, whose aligned blocks of 2^k points are nets; every further 2^32 have a scramble of their own.
/// Each seed is an independent replicate: all pairs of points have the joint distribution of Owen's nested uniform
/// scramble, so estimates are unbiased and have the variance of his. Owen 1997, "Scrambled net variance for integrals
/// of smooth functions".
class SobolPoints {
 public:
  explicit SobolPoints(std::uint64_t seed);

  /// One coordinate, strictly inside (0, 1), the centre of one of 2^52 equal cells. 0 <= dimension < kSobolDimensions.
  double at(std::uint64_t index, int dimension) const;

  /// The same for `count` indices in any order; fastest where neighbours differ in few bits.
  void fill(const std::uint64_t* indices, int count, int dimension, double* out) const;

 private:
  struct Scramble {
    std::uint32_t shift, factor, lastFactor, lastShift;  // of the 32 digits that Sobol' points have
    std::uint32_t tailFactor, tailShift;                 // of the 20 digits below them
  };
  static Scramble makeScramble(std::uint64_t seed, std::uint32_t block, int dimension);
  Scramble scrambleOf(std::uint32_t block, int dimension) const;
  struct Cell {
    std::uint32_t upper, lower;  // the coordinate's first 32 binary digits and the following 32
  };
  static Cell scrambled(std::uint32_t digits, const Scramble& scramble);
  void fillChunk(const std::uint64_t* indices, int count, int dimension, double* out) const;

  std::uint64_t seed_;
  std::array<Scramble, kSobolDimensions> firstBlock_;
};

}  // namespace parhelion
