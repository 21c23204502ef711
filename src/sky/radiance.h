// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "picture/image.h"
#include "sky/tally.h"

namespace parhelion {

/// Name of the channel that holds the variance of the luminance, (1/sr)^2.
inline constexpr const char* kVarianceChannel = "Variance.Y";

/// Name of the channel that holds the bias of the luminance, 1/sr: the root of the mean square by which the picture
/// would differ from the sky if it were the mean over very many runs. The square of a pixel's error is expected to be
/// the variance plus the square of the bias. Methods that do not estimate it have no such channel.
inline constexpr const char* kBiasChannel = "Bias.Y";

/// The plain reconstruction: each pixel's light over the intercepted light and the pixel's solid angle, 1/sr. Channels
/// R, G, B (linear Rec.709 in which the undeviated sunlight is white; all equal with one colour) and the variance of
/// the luminance from the scatter of the rays. In a pixel that no ray hit, the variance is that of one typical deposit:
/// three standard errors are then what less than 5 % of such pixels exceed (the rule of three). Pixels without sky, and
/// a tally without rays, are 0.
Image plainRadiance(const Tally& tally);

}  // namespace parhelion
