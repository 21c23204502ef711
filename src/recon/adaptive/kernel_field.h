// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "recon/adaptive/kernel_bank.h"
#include "recon/adaptive/sky_pyramid.h"

namespace parhelion {

/// What decides size and shape of the kernels at a place.
struct KernelSite {
  float density = 0.0F;  // hits per pixel area
  KernelShape shape;
};

/// The sites of all pixels, and their means over the sky of coarser cells.
class KernelField {
 public:
  KernelField(const SkyPyramid& sky, Raster<KernelSite> pixels);

  int levels() const { return static_cast<int>(levels_.size()); }
  const Raster<KernelSite>& level(int l) const { return levels_[static_cast<std::size_t>(l)]; }
  const Raster<KernelSite>& pixels() const { return levels_[0]; }

 private:
  std::vector<Raster<KernelSite>> levels_;
};

}  // namespace parhelion
