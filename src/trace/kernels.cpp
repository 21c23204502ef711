// SPDX-License-Identifier: Apache-2.0
#include "trace/kernels.h"

#include <stdexcept>

namespace parhelion {

// Each in an object file of its own, from kernels_lanes.cpp.
extern const Kernels kernelsOf2;
#ifdef PARHELION_X86
extern const Kernels kernelsOf4, kernelsOf8;
#endif

std::vector<Simd> simdHere() {
  std::vector<Simd> here{Simd::baseline};
#ifdef PARHELION_X86
  if (__builtin_cpu_supports("avx2")) here.push_back(Simd::avx2);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq")) here.push_back(Simd::avx512);
#endif
  return here;
}

const Kernels& kernels(Simd simd) {
  static const std::vector<Simd> here = simdHere();
  if (simd == Simd::automatic) simd = here.back();
  bool found = false;
  for (const Simd one : here) found |= one == simd;
  if (!found) throw std::invalid_argument("this machine does not have the vector registers asked for");
#ifdef PARHELION_X86
  if (simd == Simd::avx2) return kernelsOf4;
  if (simd == Simd::avx512) return kernelsOf8;
#endif
  return kernelsOf2;
}

}  // namespace parhelion
