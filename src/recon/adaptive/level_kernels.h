// SPDX-License-Identifier: Apache-2.0
#pragma once

// Kernels on the cells of a pyramid's levels: cells of level l cover 2^l x 2^l pixels.

#include <algorithm>
#include <cmath>

#include "recon/adaptive/kernel_field.h"
#include "recon/kernel_variance.h"

namespace parhelion {

inline float pixelsPerCell(int level) { return static_cast<float>(1U << (2 * level)); }

/// The level on whose cells the short axis of a kernel is a standard deviation of 1 to 2.
inline int levelOf(float variance, float aspect, int levels) {
  const float minor2 = variance / aspect;
  return minor2 < 4.0F ? 0 : std::min(static_cast<int>(0.5F * roughLog2(minor2)), levels - 1);
}

/// The variance (cells^2) that summing into the cells of a level and interpolating between them add to a kernel.
inline float blurOf(int level) { return (1.0F - 1.0F / pixelsPerCell(level)) / 3.0F; }

inline const Kernel& kernelFor(float variance, KernelShape shape, int level) {
  return kernelBank().nearest(variance / pixelsPerCell(level), shape, blurOf(level));
}

inline const Kernel& kernelAt(const Raster<KernelSite>& sites, int x, int y, double hits, int level) {
  const KernelSite& site = sites.at(x, y);
  return kernelFor(kernelVariance(hits, site.density), site.shape, level);
}

/// No kernel of kernelAt() reaches farther, cells: the bank's nearest may be longer by half a step of its widths and
/// aspects.
inline int mostReach(const KernelSite& site, double hits, int level) {
  constexpr float kSteps = 1.25F;
  const float major2 = kernelVariance(hits, site.density) * site.shape.aspect() / pixelsPerCell(level);
  const float reach = kSteps * std::sqrt(KernelBank::kSupport * major2) + 2.0F;
  return static_cast<int>(std::min(reach, static_cast<float>(KernelBank::kMaxReach)));
}

}  // namespace parhelion
