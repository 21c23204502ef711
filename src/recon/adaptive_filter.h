// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recon/gated_sum.h"
#include "recon/watch.h"

namespace parhelion {

/// Hits under a middling kernel, for a picture of so many hits.
double hitsPerKernel(double hits);

/// Density-adaptive, anisotropic scatter with gated corrections. Light 0 of a pixel is its luminance in effective hits
/// (scaled so that their sum equals the sum of their squares), light 1 the difference between two independent halves of
/// it, lights 2 and 3 are X and Z. Pixels without sky must be 0, and not all may be.
/// Comes back per relative solid angle (SkyLevel::omega).
/// `totalHits` is the sum of light 0 over the picture, without a band around it that repeats parts of it.
template <std::size_t N>
Grid<Light<N>> adaptiveFilter(const SkyPyramid& sky, const Grid<Light<N>>& light, double totalHits, const Watch& watch);

extern template Grid<Light<2>> adaptiveFilter(const SkyPyramid&, const Grid<Light<2>>&, double, const Watch&);
extern template Grid<Light<4>> adaptiveFilter(const SkyPyramid&, const Grid<Light<4>>&, double, const Watch&);

}  // namespace parhelion
