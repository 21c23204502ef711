// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/conventions.h"

namespace parhelion {

/// Area of the kernel (product of its standard deviations, pixels^2) under which `hits` hits lie as under a Gaussian
/// of that area, where a pixel gets `density`; at most what a picture can hold.
inline float kernelVariance(double hits, float density) {
  constexpr double kMostVariance = 1e10;  // pixels^2: the square of three times the largest picture's side
  const double perVariance = 4.0 * kPi * static_cast<double>(density);
  return static_cast<float>(perVariance * kMostVariance > hits ? hits / perVariance : kMostVariance);
}

}  // namespace parhelion
