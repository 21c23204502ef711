// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/lanes.h"

namespace parhelion {

/// exp(-x) for x >= 0 within 3e-16 of it; that of 700 for all above. Being made of additions and products alone, the
/// same bits everywhere.
template <class T>
PARHELION_INLINE T expOfMinus(const T& x) {
  constexpr double kMost = 700.0, kPerLn2 = 1.4426950408889634;
  constexpr double kLn2High = 0x1.62e42fefa0000p-1, kLn2Low = 0x1.cf79abc9e3b3ap-40;  // Cody & Waite
  const T within = lower(x, all<T>(kMost));
  const T halvings = nearest(kPerLn2 * within);
  const T r = (halvings * kLn2High - within) + halvings * kLn2Low;  // at most half of ln 2
  // Taylor's series: the first term left out is below 1e-17.
  T sum = all<T>(1.0 / 6227020800.0);
  for (const double factorial :
       {479001600.0, 39916800.0, 3628800.0, 362880.0, 40320.0, 5040.0, 720.0, 120.0, 24.0, 6.0, 2.0, 1.0, 1.0})
    sum = sum * r + 1.0 / factorial;
  // 2^-halvings by its exponent, from whole numbers behind 2^52.
  constexpr std::uint64_t kDigits = (std::uint64_t{1} << 52) - 1;
  const WordsOf<T> exponent = bitsAs<WordsOf<T>>((1023.0 - halvings) + 0x1p52) & kDigits;
  return sum * bitsAs<T>(exponent << 52);
}

}  // namespace parhelion
