// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recon/hit_map.h"
#include "recon/recon_settings.h"
#include "recon/reconstruct.h"
#include "recon/watch.h"

namespace parhelion {

// How the methods work, one function each, told apart by their settings. A method is given either the tally or, when it
// knows nothing but pixels, the hits in them: reconstruct() takes whichever of the two there is.

/// Every hit is spread over a kernel. The kernel's size follows the density of hits, its shape follows the arcs. The
/// picture of wide kernels comes first. Then ever narrower kernels correct it, and a correction is kept only where it
/// stands above the noise. The luminance is never negative, and all light in pixels with sky is kept.
ReconstructedSky reconstructSky(const Tally& tally, const AdaptiveSettings& settings, const Watch& watch);

/// The plain radiance of the pixels.
ReconstructedSky reconstructSky(const Tally& tally, const NoSettings& settings, const Watch& watch);

// The methods of the literature.

/// One Gaussian for the whole picture: K * light / K * omega, so that a constant sky stays constant up to the border.
Reconstruction reconstructHits(const HitMap& map, const GaussianSettings& settings, const Watch& watch);

/// The mean of several Gaussian means (published/gaussian.h), of standard deviation 1, 2, 4, ... pixels.
/// Glassner, Computer-generated solar halos and sun dogs, 1996.
Reconstruction reconstructHits(const HitMap& map, const GlassnerSettings& settings, const Watch& watch);

/// One low-pass filter over all pixels, the empty ones as 0: a density. Each iteration then corrects at the pixels hit
/// alone, which have more than the mean, and so brightens the picture; see published/allebach.h for when that is
/// stopped. Marvasti, Analoui & Gamshadzahi, Recovery of signals from nonuniform samples using iterative methods, 1991.
Reconstruction reconstructHits(const HitMap& map, const MarvastiSettings& settings, const Watch& watch);

/// Every pixel takes the value of the nearest hit, then a low-pass filter, then iterations that correct by the
/// residual, spread in the same way: of intensities what is missing at the hits, of densities what is missing in their
/// cells. The latter keeps the light, but for what the border's normalisation moves. Sauer & Allebach, Iterative
/// reconstruction of band-limited images from nonuniformly spaced samples, 1987.
Reconstruction reconstructHits(const HitMap& map, const VoronoiSettings& settings, const Watch& watch);

/// Adaptive weights and conjugate gradients on Toeplitz matrices: the trigonometric polynomial nearest to the hits,
/// each weighted by the area of its Voronoi cell, approached from the mean in `iterations` steps. The steps are chosen
/// by the first light; all others take the same. Feichtinger, Groechenig & Strohmer, Efficient numerical methods in
/// non-uniform sampling theory, 1995.
Reconstruction reconstructHits(const HitMap& map, const ActSettings& settings, const Watch& watch);

/// Windowed-sinc kernels whose size follows the hits: around each pixel a square of 2r + 1 pixels grows until it holds
/// m of them, and r = k Ts. Gonzato & Marchand, Photo-realistic simulation and rendering of halos, 2001.
///
/// Unit gain: kernels add up to 1 and every pixel counts, the empty ones as 0: an estimate of density. Scatter keeps
/// the sum of light exactly, gather within a few per cent; kernels that reach the border of the sky are made up for
/// what they lose there (published/sky_balance.h). Each iteration adds the filtered difference between the map and the
/// picture: sharper and noisier, with the raw map as the limit.
///
/// Paper gain: the kernels as the windowed sinc has them, on the values of the pixels with hits (hits per solid angle),
/// to be corrected by iterations at these pixels alone. Their gain grows as Ts^2, as the density falls: a local mean of
/// the values times about m/4, which knows nothing of density.
///
/// Iterations that would make the difference grow are stopped; a remark says so. Pictures one pixel high or wide are
/// signals: squares are intervals, kernels the cut through their middle.
Reconstruction reconstructHits(const HitMap& map, const GonzatoMarchandSettings& settings, const Watch& watch);

}  // namespace parhelion
