// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "math/conventions.h"
#include "picture/chromaticities.h"

namespace parhelion {

/// Luminance of linear Rec.709 red, green and blue: the Y row of their matrix (ITU-R BT.709 primaries, D65).
inline constexpr Vec3 kRec709Luminance{0.2126390058715104, 0.7151686787677559, 0.0721923153607337};

/// CIE XYZ to linear Rec.709 with D65 white, after a Bradford adaptation that takes `white` (XYZ) exactly to
/// R = G = B = 1. The light of a few spectral lines may lie so far from white that no eye adapts to it (a cone
/// response is not positive): that is shown unadapted, in its own colour.
Mat3 xyzToRec709(const Vec3& white);

/// CIE XYZ to linear Rec.709 as it is: nothing is adapted, and Y is the luminance of R, G and B.
Mat3 xyzToRec709();

/// From what xyzToRec709(white) gives back to CIE XYZ.
Mat3 rec709ToXyz(const Vec3& white);

/// Linear R, G, B of a colour space with these primaries and white to linear Rec.709, after the same adaptation: its
/// white becomes white. None where they make no colour space: numbers that are none, or a white that does not lie among
/// the primaries.
std::optional<Mat3> rgbToRec709(const Chromaticities& from);

}  // namespace parhelion
