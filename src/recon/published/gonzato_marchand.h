// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recon/hit_map.h"
#include "recon/recon_settings.h"
#include "recon/watch.h"

namespace parhelion {

/// Windowed-sinc kernels whose size follows the hits: around each pixel a square of 2r + 1 pixels grows until it holds
/// m of them, and r = k Ts. Gonzato & Marchand, Photo-realistic simulation and rendering of halos, 2001.
///
/// Unit gain: kernels add up to 1 and every pixel counts, the empty ones as 0: an estimate of density. Scatter keeps
/// the sum of light exactly, gather within a few per cent; kernels that reach the border of the sky are made up for
/// what they lose there (sky_balance.h). Each iteration adds the filtered difference between the map and the picture:
/// sharper and noisier, with the raw map as the limit.
///
/// Paper gain: the kernels as the windowed sinc has them, on the values of the pixels with hits (hits per solid angle),
/// to be corrected by iterations at these pixels alone. Their gain grows as Ts^2, as the density falls: a local mean of
/// the values times about m/4, which knows nothing of density.
///
/// Iterations that would make the difference grow are stopped; a remark says so. Pictures one pixel high or wide are
/// signals: squares are intervals, kernels the cut through their middle.
Reconstruction gonzatoMarchand(const HitMap& map, const GonzatoMarchandSettings& settings, const Watch& watch);

/// The m that suits a map of so many hits, for unit gain and one lobe. Larger k need k^2 times as many.
double hitsPerSquare(double hits);

}  // namespace parhelion
