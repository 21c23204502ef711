// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "picture/image.h"
#include "picture/tone.h"

namespace parhelion {

/// How far a picture of the sky can be believed: the standard error of each pixel's luminance over the luminance (of
/// Rec.709), as grey. The square of the error is the variance plus the square of the bias, if the picture has one.
/// White is 1 % or less, black 100 % or more and all pixels without light; between them the grey's 8-bit value falls
/// with the logarithm of the error, so 10 % is 128. Pixels that are not finite are black and counted. Throws
/// std::invalid_argument if R, G, B or the variance (kVarianceChannel) is missing.
Preview confidence(const Image& sky);

}  // namespace parhelion
