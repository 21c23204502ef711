// SPDX-License-Identifier: Apache-2.0
#include "math/random.h"

namespace parhelion {

namespace {

std::uint32_t lowWord(std::uint64_t x) { return static_cast<std::uint32_t>(x); }
std::uint32_t highWord(std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); }

}  // namespace

std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
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

void RandomStream::refill() {
  const auto words = philox4x32({block_++, static_cast<std::uint32_t>(purpose_), lowWord(ray_), highWord(ray_)},
                                {lowWord(seed_), highWord(seed_)});
  words_[0] = toUnitInterval(std::uint64_t{words[1]} << 32 | words[0]);
  words_[1] = toUnitInterval(std::uint64_t{words[3]} << 32 | words[2]);
  used_ = 0;
}

}  // namespace parhelion
