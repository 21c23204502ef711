// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "picture/image.h"

namespace parhelion {

/// How well a picture of the sky is known: the standard errors of its pixels' luminance together over their luminance
/// together, each by its solid angle,
///
///     sum(omega sqrt(variance + bias^2)) / sum(omega L).
///
/// It is the mean relative error, in which a pixel counts by the light that it has. So it is the bright parts of the
/// sky that matter, and no threshold says which these are. Of a plain picture, whose unhit pixels have the variance of
/// a typical deposit, it is well above 1 as long as most pixels are unhit.
///
/// `sky` is linear Rec.709 with kVarianceChannel and, where the method knows it, kBiasChannel (sky/radiance.h). Pixels
/// that are not finite are left out. A picture without light has infinite error. `solidAngles` are in sr, row-major.
/// Throws std::invalid_argument if R, G, B or the variance is missing, or sizes differ.
double pictureError(const Image& sky, std::span<const double> solidAngles);

}  // namespace parhelion
