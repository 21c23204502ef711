// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recon/scatter.h"

namespace parhelion {

/// What the filter makes of scattered hits, per relative solid angle (SkyLevel::omega).
struct Filtered {
  /// Luminance and the difference between its halves, through the same kernels and gates.
  Grid<Light<2>> luminance;
  /// Luminance, X and Z through kernels of four times as many hits; only their ratios are of use. Empty without colour.
  Grid<Light<3>> colour;
};

/// Hits under a middling kernel, for a picture of so many hits.
double hitsPerKernel(double hits);

/// Density-adaptive, anisotropic scatter with gated corrections. Light 0 of a pixel is its luminance in effective hits
/// (scaled so that their sum equals the sum of their squares), light 1 the difference between two independent halves of
/// it, lights 2 and 3 are X and Z. `firstDensity` is a rough guess of light 0 per relative solid angle. Pixels without
/// sky must be 0, and not all may be.
template <std::size_t N>
Filtered adaptiveFilter(const SkyPyramid& sky, const Grid<Light<N>>& light, const Grid<float>& firstDensity);

extern template Filtered adaptiveFilter(const SkyPyramid&, const Grid<Light<2>>&, const Grid<float>&);
extern template Filtered adaptiveFilter(const SkyPyramid&, const Grid<Light<4>>&, const Grid<float>&);

}  // namespace parhelion
