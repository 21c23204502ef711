// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recon/published/sinc_bank.h"
#include "recon/published/square_sizes.h"
#include "recon/recon_settings.h"

namespace parhelion {

/// What makes up for the light that kernels of unit gain lose beyond the border of the sky; 1 where a kernel does not
/// reach the border.
///
/// Gather: 1 / (K * share) with the pixel's own kernel K. Scatter: factors g with g (K * (share g)) = 1, which balance
/// sources and targets alike (Sinkhorn & Knopp 1967): light that leaves a source times g, and counts at a target times
/// g, keeps its sum and leaves an even sky even wherever sizes change slowly. Kernels of up to 24 pixels are balanced
/// pixel by pixel, within 1e-3; larger ones on cells of 2^n pixels, within 1 % for one lobe and 3 % for two.
Raster<float> borderFactors(const SkyExtent& sky, const Raster<int>& radii, const SincBank& bank, double lobes,
                            KernelFlow flow);

/// Whether the kernel of each pixel of the sky reaches beyond the picture, or to where `ones` is not 1.
Raster<char> reachesBeyond(const Raster<float>& ones, const SkyExtent& sky, const Raster<int>& radii,
                           const SincBank& bank);

}  // namespace parhelion
