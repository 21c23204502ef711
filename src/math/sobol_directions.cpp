// SPDX-License-Identifier: Apache-2.0
#include "math/sobol.h"

namespace parhelion {

namespace {

// A primitive polynomial x^degree + a_1 x^(degree-1) + ... + a_(degree-1) x + 1 over GF(2), its inner coefficients read
// as one binary number, and the odd numbers m_1 ... m_degree that start the recurrence.
struct Direction {
  int degree;
  std::uint32_t inner;
  std::array<std::uint32_t, 7> start;
};

// Dimensions 2 to 32 of the table new-joe-kuo-6. Joe & Kuo 2008, "Constructing Sobol sequences with better
// two-dimensional projections", SIAM J. Sci. Comput. 30, 2635. The first dimension is van der Corput's sequence.
constexpr std::array<Direction, kSobolDimensions - 1> kDirections{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
    {7, 7, {1, 1, 3, 13, 7, 35, 63}},
    {7, 8, {1, 3, 5, 9, 1, 25, 53}},
    {7, 14, {1, 3, 1, 13, 9, 35, 107}},
    {7, 19, {1, 3, 1, 5, 27, 61, 31}},
    {7, 21, {1, 1, 5, 11, 19, 41, 61}},
    {7, 28, {1, 3, 5, 3, 3, 13, 69}},
    {7, 31, {1, 1, 7, 13, 1, 19, 1}},
    {7, 32, {1, 3, 7, 5, 13, 19, 59}},
    {7, 37, {1, 1, 3, 9, 25, 29, 41}},
    {7, 41, {1, 3, 5, 13, 23, 1, 55}},
    {7, 42, {1, 3, 7, 3, 13, 59, 17}},
}};

// The digits that each bit of the index adds.
using Columns = std::array<std::uint32_t, 32>;

constexpr Columns vanDerCorput() {
  Columns columns{};
  for (int k = 0; k < 32; ++k) columns[k] = std::uint32_t{1} << k;
  return columns;
}

constexpr Columns columnsOf(const Direction& direction) {
  const int s = direction.degree;
  Columns columns{};
  // m_(k+1) / 2^(k+1), digit by digit.
  for (int k = 0; k < s; ++k)
    for (int digit = 0; digit <= k; ++digit) columns[k] |= (direction.start[k] >> (k - digit) & 1) << digit;
  // The linear recurrence of the polynomial; a division by 2^s moves digits up by s places.
  for (int k = s; k < 32; ++k) {
    columns[k] = columns[k - s] ^ columns[k - s] << s;
    for (int i = 1; i < s; ++i)
      if (direction.inner >> (s - 1 - i) & 1) columns[k] ^= columns[k - i];
  }
  return columns;
}

constexpr SobolTable tableOf(const Columns& columns) {
  SobolTable table{};
  for (int group = 0; group < 8; ++group)
    for (int value = 0; value < 16; ++value)
      for (int bit = 0; bit < 4; ++bit)
        if (value >> bit & 1) table[group][value] ^= columns[4 * group + bit];
  return table;
}

constexpr std::array<SobolTable, kSobolDimensions> makeTables() {
  std::array<SobolTable, kSobolDimensions> tables{tableOf(vanDerCorput())};
  for (int i = 1; i < kSobolDimensions; ++i) tables[i] = tableOf(columnsOf(kDirections[i - 1]));
  return tables;
}

}  // namespace

constinit const std::array<SobolTable, kSobolDimensions> kSobolTables = makeTables();

}  // namespace parhelion
