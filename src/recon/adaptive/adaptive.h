// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "picture/image.h"
#include "recon/watch.h"
#include "sky/tally.h"

namespace parhelion {

/// The adaptive reconstruction, 1/sr, channels as of plainRadiance(): every hit is spread over a kernel whose size
/// follows the density of hits and whose shape follows the arcs, from wide kernels to narrow ones, and a correction by
/// narrower kernels is kept only where it stands above the noise. Never negative luminance; all light of the sky's
/// pixels is kept. The variance is that of the noise left over, measured as the difference between the pictures of the
/// two halves of the rays; it says nothing of what the smoothing itself bends.
Image adaptiveRadiance(const Tally& tally, const Watch& watch);

}  // namespace parhelion
