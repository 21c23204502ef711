// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "picture/image.h"
#include "sky/tally.h"

namespace parhelion {

/// How well a picture of the sky is known: the errors of its pixels' luminance together over their luminance together,
/// each by its solid angle,
///
///     sum(omega error) / sum(omega L).
///
/// It is the mean relative error, in which a pixel counts by the light that it has. So it is the bright parts of the
/// sky that matter, and no threshold says which these are.
///
/// A pixel's error is what its method expects, sqrt(variance + bias^2), or what the plain picture (plainRadiance()) of
/// the same rays allows, |L - plain| + the plain picture's standard error, where that is less. For the plain picture,
/// which has no bias, tells the truth where there are many hits, also where a method's own estimate is far too high. A
/// plain pixel without hits has the error of a typical hit: as long as most have none, the error of the picture is well
/// above 1.
///
/// `sky` is linear Rec.709 with kVarianceChannel and, where the method knows it, kBiasChannel (sky/radiance.h). Pixels
/// that are not finite are left out. A picture without light has infinite error. Throws std::invalid_argument if R, G,
/// B or the variance is missing, or the tally has another size.
double pictureError(const Image& sky, const Tally& tally);

/// The same for the plain picture itself.
double plainError(const Tally& tally);

/// sum(omega L) of a picture that this camera took, linear Rec.709. Pixels that are not finite are left out.
double pictureLight(const Image& sky, const CameraSettings& camera);

}  // namespace parhelion
