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

template <class Row>
PARHELION_INLINE Triple<Real> loadTriple(const Row* rows, int i) {
  return {load<Real>(&rows[0][i]), load<Real>(&rows[1][i]), load<Real>(&rows[2][i])};
}
template <class Row>
PARHELION_INLINE void storeTriple(Row* rows, int i, const Triple<Real>& v) {
  store(&rows[0][i], v.x);
  store(&rows[1][i], v.y);
  store(&rows[2][i], v.z);
}

PARHELION_INLINE Triple<Real> normalOf(const FaceTable& faces, const Real& face) {
  return lookUpTriple(faces.normal, face);
}

}  // namespace
}  // namespace parhelion
