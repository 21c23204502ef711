// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "math/conventions.h"
#include "recon/adaptive/kernel_bank.h"
#include "recon/adaptive/sky_pyramid.h"

namespace parhelion {

/// What decides size and shape of the kernels at a place.
struct KernelSite {
  float density = 0.0F;  // hits per pixel area
  KernelShape shape;
};

/// Area of the kernel (product of its standard deviations, pixels^2) under which `hits` hits lie as under a Gaussian
/// of that area, where a pixel gets `density`; at most what a picture can hold.
inline float kernelVariance(double hits, float density) {
  constexpr double kMostVariance = 1e10;  // pixels^2: the square of three times the largest picture's side
  const double perVariance = 4.0 * kPi * static_cast<double>(density);
  return static_cast<float>(perVariance * kMostVariance > hits ? hits / perVariance : kMostVariance);
}

/// The sites of all pixels, and their means over the sky of coarser cells.
class KernelField {
 public:
  KernelField(const SkyPyramid& sky, Grid<KernelSite> pixels);

  int levels() const { return static_cast<int>(levels_.size()); }
  const Grid<KernelSite>& level(int l) const { return levels_[static_cast<std::size_t>(l)]; }
  const Grid<KernelSite>& pixels() const { return levels_[0]; }

 private:
  std::vector<Grid<KernelSite>> levels_;
};

}  // namespace parhelion
