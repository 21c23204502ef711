// SPDX-License-Identifier: Apache-2.0
#include "trace/lane_steps.h"

#include <stdexcept>

namespace parhelion {

// Each in an object file of its own, from lane_code.cpp.
extern const LaneSteps laneStepsOf2;
#ifdef PARHELION_X86
extern const LaneSteps laneStepsOf4, laneStepsOf8;
#endif

std::vector<Simd> simdHere() {
  std::vector<Simd> here{Simd::baseline};
#ifdef PARHELION_X86
  if (__builtin_cpu_supports("avx2")) here.push_back(Simd::avx2);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) here.push_back(Simd::avx512);
#endif
  return here;
}

const LaneSteps& laneSteps(Simd simd) {
  static const std::vector<Simd> here = simdHere();
  if (simd == Simd::automatic) simd = here.back();
  bool found = false;
  for (const Simd one : here) found |= one == simd;
  if (!found) throw std::invalid_argument("this machine does not have the vector registers asked for");
#ifdef PARHELION_X86
  if (simd == Simd::avx2) return laneStepsOf4;
  if (simd == Simd::avx512) return laneStepsOf8;
#endif
  return laneStepsOf2;
}

}  // namespace parhelion
