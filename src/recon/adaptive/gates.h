// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recon/adaptive/scatter.h"

namespace parhelion {

/// Squares of corrections count at most so much: a correction of 100 times the density is as sure as any, and larger
/// ones, in holes, would drown the sums around them.
inline constexpr float kMostSquare = 1e4F;

/// Half the side, in blocks of 2 x 2 pixels, of the windows over which corrections by kernels of `hits` hits are
/// averaged around a block: somewhat wider than the kernels.
int windowRadius(const KernelField& field, int x, int y, double hits);

/// Sums over the sky pixels of a block of 2 x 2. They decide how much of a correction is kept. A correction is the
/// difference that kernels of n hits make to the picture of kernels of 4n hits. Everything is relative to the density
/// that placed the kernels.
struct CorrectionSquares {
  float correction = 0.0F;  // squares of the correction
  float noise = 0.0F;       // the value of these squares that Poisson noise alone would give
  float colour = 0.0F;      // squares of the correction's changes of X - Y and Z - Y, where white has X = Y = Z
  float pixels = 0.0F;
};

/// The sums of all blocks, at half resolution, and how the noise compares with that of independent hits.
struct Corrections {
  Raster<CorrectionSquares> blocks;
  double noiseRatio = 1.0;   // measured variance over that of independent hits
  double colourRatio = 1.0;  // squares that noise makes in colour, over those that it would make in the luminance
};

/// Compares the pictures `wide` of 4n hits per kernel and `narrow` of n = `hits` hits per kernel.
///
/// Light 0 of a pixel is the luminance. Light 1 is the difference between two independent halves of it, whose square is
/// pure noise. Lights 2 and 3 are X and Z relative to white. They have no halves. So their noise is estimated from the
/// median over the blocks, as if nothing but noise changed the colour in half of all blocks.
template <std::size_t N>
Corrections compareSizes(const SkyPyramid& sky, const KernelField& field, const Raster<Light<N>>& wide,
                         const Raster<Light<N>>& narrow, double hits);

extern template Corrections compareSizes(const SkyPyramid&, const KernelField&, const Raster<Light<2>>&,
                                         const Raster<Light<2>>&, double);
extern template Corrections compareSizes(const SkyPyramid&, const KernelField&, const Raster<Light<4>>&,
                                         const Raster<Light<4>>&, double);

/// How much of each correction to keep, from 0 to 1, at half resolution.
///
/// Squares of correction and noise are averaged over windows somewhat wider than the kernels. The share of the mean
/// square that exceeds `caution` times the noise is kept. A gate is never above its counterpart in `coarser`, the gates
/// of the wider kernels (empty: there are none). So any sum of gated corrections is a weighted mean of the filtered
/// pictures, and stays positive.
Raster<float> correctionGates(const Corrections& corrections, const KernelField& field, double hits, double caution,
                              const Raster<float>& coarser);

/// The same for the corrections of colour.
Raster<float> colourGates(const Corrections& corrections, const KernelField& field, double hits, double caution,
                          const Raster<float>& coarser);

/// The gate at a pixel, interpolated between the centres of the blocks.
float gateAt(const Raster<float>& gates, int x, int y);

}  // namespace parhelion
