// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recon/adaptive/scatter.h"

namespace parhelion {

/// What decides whether a correction, from kernels of 4n hits to kernels of n hits, is kept: sums over the sky pixels
/// of a block of 2 x 2, everything relative to the pilot density.
struct CorrectionSquares {
  float correction = 0.0F;  // squares of the correction
  float noise = 0.0F;       // what Poisson noise alone would make of them
  float colour = 0.0F;      // squares of what it changes in X - Y and Z - Y, X and Z being 1 where the light is white
  float pixels = 0.0F;
};

/// Corrections at half resolution, and how the noise compares with that of independent hits.
struct Corrections {
  Raster<CorrectionSquares> blocks;
  double noiseRatio = 1.0;   // measured variance over that of independent hits
  double colourRatio = 1.0;  // of what the noise changes in colour over what it would change in the luminance
};

/// Compares the pictures of 4n and n = `hits` hits a kernel. Of every pixel, light 0 is the luminance and light 1 the
/// difference between two independent halves of it, whose square is pure noise. Lights 2 and 3 are X and Z relative to
/// white. Of these there are no halves: what changes in colour is taken for noise in half of all blocks.
template <std::size_t N>
Corrections compareSizes(const SkyPyramid& sky, const KernelField& field, const Raster<Light<N>>& wide,
                         const Raster<Light<N>>& narrow, double hits);

extern template Corrections compareSizes(const SkyPyramid&, const KernelField&, const Raster<Light<2>>&,
                                         const Raster<Light<2>>&, double);
extern template Corrections compareSizes(const SkyPyramid&, const KernelField&, const Raster<Light<4>>&,
                                         const Raster<Light<4>>&, double);

/// How much of each correction to keep, 0 to 1, at half resolution: all of what exceeds `caution` times the noise in
/// the mean over windows somewhat wider than the kernels, and never more than `coarser`, the gates of the wider
/// kernels (empty: none). So any sum of gated corrections is a mean of the filtered pictures: it stays positive.
Raster<float> correctionGates(const Corrections& corrections, const KernelField& field, double hits, double caution,
                              const Raster<float>& coarser);

/// The same for corrections of colour.
Raster<float> colourGates(const Corrections& corrections, const KernelField& field, double hits, double caution,
                          const Raster<float>& coarser);

/// A gate at a pixel, between the centres of the blocks.
float gateAt(const Raster<float>& gates, int x, int y);

}  // namespace parhelion
