// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "picture/image.h"
#include "recon/watch.h"
#include "sky/tally.h"

namespace parhelion {

/// The adaptive reconstruction, in 1/sr, with the channels of plainRadiance().
///
/// Every hit is spread over a kernel. The kernel's size follows the density of hits, its shape follows the arcs. The
/// picture of wide kernels comes first. Then ever narrower kernels correct it, and a correction is kept only where it
/// stands above the noise. The luminance is never negative, and all light in pixels with sky is kept.
///
/// The variance is that of the noise that is left, measured by the difference between the pictures of the two halves of
/// the rays. It does not include the blur of the smoothing itself.
Image adaptiveRadiance(const Tally& tally, const Watch& watch);

}  // namespace parhelion
