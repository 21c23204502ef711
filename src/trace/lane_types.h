// SPDX-License-Identifier: Apache-2.0
#pragma once

// Part of lane_code.cpp, and of nothing else.

#include "math/lanes.h"
#include "trace/lane_steps.h"

namespace parhelion {
namespace {

constexpr int kLanes = PARHELION_LANES;
using Real = Lanes<kLanes>::Real;
using Mask = Lanes<kLanes>::Mask;
using Words = Lanes<kLanes>::Words;

/// 0, 1, 2, ...
PARHELION_INLINE Real counting() {
  Real lanes;
  for (int k = 0; k < kLanes; ++k) lanes[k] = k;
  return lanes;
}

/// The lanes from place i on that are below `end`.
PARHELION_INLINE Mask below(int i, int end) { return counting() < static_cast<double>(end - i); }

PARHELION_INLINE Triple<Real> loadTriple(const RayQueue::Row* rows, int i) {
  return {load<Real>(&rows[0][i]), load<Real>(&rows[1][i]), load<Real>(&rows[2][i])};
}
PARHELION_INLINE Triple<Real> loadTriple(const RayPool::Numbers* rows, int i) {
  return {load<Real>(&rows[0][i]), load<Real>(&rows[1][i]), load<Real>(&rows[2][i])};
}
template <class Rows>
PARHELION_INLINE void storeTriple(Rows* rows, int i, const Triple<Real>& v) {
  store(&rows[0][i], v.x);
  store(&rows[1][i], v.y);
  store(&rows[2][i], v.z);
}

PARHELION_INLINE Triple<Real> normalOf(const FaceTable& faces, const Real& face) {
  return {lookUp(faces.x.data(), face), lookUp(faces.y.data(), face), lookUp(faces.z.data(), face)};
}

/// Philox4x32-10 as philox4x32() of math/random.h has it, one counter a lane; the halves above 32 bits are rubbish
/// until the end.
struct PhiloxWords {
  Words a, b, c, d;
};
PARHELION_INLINE PhiloxWords philox(Words a, Words b, Words c, Words d, std::uint64_t seed) {
  std::uint32_t key0 = static_cast<std::uint32_t>(seed), key1 = static_cast<std::uint32_t>(seed >> 32);
  for (int round = 0; round < 10; ++round) {
    const Words product0 = product32(a, 0xD2511F53), product1 = product32(c, 0xCD9E8D57);
    a = (product1 >> 32) ^ b ^ key0;
    b = product1;
    c = (product0 >> 32) ^ d ^ key1;
    d = product0;
    key0 += 0x9E3779B9;
    key1 += 0xBB67AE85;
  }
  return {a, b, c, d};
}

/// Two words of 64 bits from a block.
struct RandomWords {
  Words first, second;
};
PARHELION_INLINE RandomWords randomWords(std::uint64_t seed, RandomPurpose purpose, std::uint32_t block,
                                         const Words& bundle) {
  const Words zero{};
  const PhiloxWords w =
      philox(zero + std::uint64_t{block}, zero + static_cast<std::uint64_t>(purpose), bundle, bundle >> 32, seed);
  constexpr std::uint64_t kLow = 0xFFFFFFFF;
  return {(w.b << 32) | (w.a & kLow), (w.d << 32) | (w.c & kLow)};
}

}  // namespace
}  // namespace parhelion
