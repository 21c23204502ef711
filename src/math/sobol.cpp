// SPDX-License-Identifier: Apache-2.0
#include "math/sobol.h"

#include <algorithm>
#include <bit>
#include <cassert>

#include "math/random.h"

namespace parhelion {

namespace {

// Takes the place of RandomPurpose in Philox's counter, so that no ray's random numbers meet the scrambles.
constexpr std::uint32_t kScrambleStream = 0x536F626F;

// Short enough for the indices of a run to share all but a few bits, long enough to vectorise.
constexpr int kChunk = 64;

// The exchange of bytes stands apart from that of halves: together GCC would make them one instruction without a vector
// form.
inline std::uint32_t reverseBits(std::uint32_t x) {
  x = (x >> 8 & 0x00FF00FF) | (x & 0x00FF00FF) << 8;
  x = (x >> 4 & 0x0F0F0F0F) | (x & 0x0F0F0F0F) << 4;
  x = (x >> 2 & 0x33333333) | (x & 0x33333333) << 2;
  x = (x >> 1 & 0x55555555) | (x & 0x55555555) << 1;
  return x >> 16 | x << 16;
}

}  // namespace

SobolPoints::SobolPoints(std::uint64_t seed) : seed_(seed) {
  for (int dimension = 0; dimension < kSobolDimensions; ++dimension)
    firstBlock_[dimension] = makeScramble(seed, 0, dimension);
}

SobolPoints::Scramble SobolPoints::makeScramble(std::uint64_t seed, std::uint32_t block, int dimension) {
  const auto words = [&](std::uint64_t half) {
    return philox<std::uint64_t>({static_cast<std::uint64_t>(dimension), kScrambleStream, block, half}, seed);
  };
  const PhiloxBlock<std::uint64_t> a = words(0), b = words(1);
  return {.shift = lowWord(a.a),
          .factor = lowWord(a.b) | 1,
          .lastFactor = lowWord(a.c) | 1,
          .lastShift = lowWord(a.d),
          .tailFactor = lowWord(b.a),
          .tailShift = lowWord(b.b)};
}

SobolPoints::Scramble SobolPoints::scrambleOf(std::uint32_t block, int dimension) const {
  return block == 0 ? firstBlock_[dimension] : makeScramble(seed_, block, dimension);
}

// Each step maps a digit by the heavier digits alone. Let two points first differ at some digit. A random shift makes
// the one uniform; a random odd factor makes their difference, hence the other's lighter digits, uniform given the
// first: the joint distribution of Owen's scramble, exactly. The steps before the last only have to keep the digit at
// which they differ; they break the lattice that a single shift and factor would keep. The form x ^= x * even is Laine
// & Karras 2011, the constant Vegdahl's of 2021 ("Building a better LK hash").
inline SobolPoints::Cell SobolPoints::scrambled(std::uint32_t digits, const Scramble& scramble) {
  digits = (digits + scramble.shift) * scramble.factor;
  digits ^= digits * 0x3D20ADEA;
  return {reverseBits(digits * scramble.lastFactor + scramble.lastShift),
          digits * scramble.tailFactor + scramble.tailShift};
}

double SobolPoints::at(std::uint64_t index, int dimension) const {
  assert(dimension >= 0 && dimension < kSobolDimensions);
  const auto cell = scrambled(sobolDigits(lowWord(index), dimension), scrambleOf(highWord(index), dimension));
  return toUnitInterval(fromWords(cell.upper, cell.lower));
}

void SobolPoints::fill(const std::uint64_t* indices, int count, int dimension, double* out) const {
  assert(dimension >= 0 && dimension < kSobolDimensions);
  for (int start = 0; start < count; start += kChunk)
    fillChunk(indices + start, std::min(count - start, kChunk), dimension, out + start);
}

void SobolPoints::fillChunk(const std::uint64_t* indices, int count, int dimension, double* out) const {
  const std::uint64_t first = indices[0];
  std::uint64_t varying = 0;
  for (int i = 1; i < count; ++i) varying |= indices[i] ^ first;
  if (highWord(varying) != 0) {
    for (int i = 0; i < count; ++i) out[i] = at(indices[i], dimension);
    return;
  }

  // What all share is looked up once; each bit in which they differ then adds its column where it does.
  const SobolTable& table = kSobolTables[dimension];
  std::array<std::uint32_t, kChunk> changed, upper, lower;
  for (int i = 0; i < count; ++i) changed[i] = lowWord(indices[i] ^ first);
  std::fill_n(upper.begin(), count, sobolDigits(lowWord(first), dimension));
  for (std::uint32_t left = lowWord(varying); left != 0; left &= left - 1) {
    const int bit = std::countr_zero(left);
    const std::uint32_t column = table[bit / 4][1 << bit % 4];
    for (int i = 0; i < count; ++i) upper[i] ^= column & -(changed[i] >> bit & 1);
  }

  // Loops of one word size each, which compilers vectorise.
  const Scramble scramble = scrambleOf(highWord(first), dimension);
  for (int i = 0; i < count; ++i) {
    const Cell cell = scrambled(upper[i], scramble);
    upper[i] = cell.upper;
    lower[i] = cell.lower;
  }
  for (int i = 0; i < count; ++i) out[i] = toUnitInterval(fromWords(upper[i], lower[i]));
}

}  // namespace parhelion
