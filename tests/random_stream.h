// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/random.h"

namespace parhelion {

/// Random numbers one after the other, for one ray and one purpose: a pure function of (seed, ray index, purpose,
/// position).
class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t rayIndex, RandomPurpose purpose)
      : seed_(seed), ray_(rayIndex), purpose_(purpose) {}

  /// The next number, strictly inside (0, 1).
  double next() {
    const bool second = used_++ % 2 != 0;
    if (!second) words_ = randomWords(seed_, purpose_, block_++, ray_);
    return toUnitInterval(second ? words_.second : words_.first);
  }

 private:
  std::uint64_t seed_;
  std::uint64_t ray_;
  RandomPurpose purpose_;
  std::uint32_t block_ = 0, used_ = 0;
  RandomWords<std::uint64_t> words_{};
};

}  // namespace parhelion
