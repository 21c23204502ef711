// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "picture/image.h"
#include "sky/tally.h"

namespace parhelion {

/// Name of the channel that holds the variance of the luminance, (1/sr)^2.
inline constexpr const char* kVarianceChannel = "Variance.Y";

/// The plain reconstruction: each pixel's light over the intercepted light and the pixel's solid angle, 1/sr. Channels
/// R, G, B (linear Rec.709 in which the undeviated sunlight is white; all equal with one colour) and the variance of
/// the luminance from the scatter of the rays. Pixels without sky, and a tally without rays, are 0.
Image plainRadiance(const Tally& tally);

}  // namespace parhelion
