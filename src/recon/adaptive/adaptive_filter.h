// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recon/adaptive/gated_sum.h"
#include "recon/watch.h"

namespace parhelion {

/// Filtered light per relative solid angle (SkyLevel::omega).
struct Filtered {
  Raster<Light<2>> luminance;  // and the difference between its halves
  Raster<Light<3>> colour;     // luminance, X and Z, of which only the ratios are of use; empty without colour
  Raster<float> leastError;    // standard error of the luminance over the luminance, if hits were independent
  Raster<float> bias;          // root mean square of the luminance that filtering moved elsewhere
};

/// Density-adaptive, anisotropic scatter with gated corrections. Light 0 of a pixel is its luminance in effective hits
/// (scaled so that their sum equals the sum of their squares), light 1 the difference between two independent halves of
/// it, lights 2 and 3 are X and Z relative to white. Pixels without sky must be 0, and not all may be.
/// `totalHits` is the sum of light 0 over the picture, without a band around it that repeats parts of it.
template <std::size_t N>
Filtered adaptiveFilter(const SkyPyramid& sky, const Raster<Light<N>>& light, double totalHits, const Watch& watch);

extern template Filtered adaptiveFilter(const SkyPyramid&, const Raster<Light<2>>&, double, const Watch&);
extern template Filtered adaptiveFilter(const SkyPyramid&, const Raster<Light<4>>&, double, const Watch&);

}  // namespace parhelion
