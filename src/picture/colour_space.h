// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/conventions.h"

namespace parhelion {

/// Luminance of linear Rec.709 red, green and blue: the Y row of their matrix (ITU-R BT.709 primaries, D65).
inline constexpr Vec3 kRec709Luminance{0.2126390058715104, 0.7151686787677559, 0.0721923153607337};

/// CIE XYZ to linear Rec.709 with D65 white, after a Bradford adaptation that takes `white` (XYZ) exactly to
/// R = G = B = 1. The light of a few spectral lines may lie so far from white that no eye adapts to it (a cone
/// response is not positive): that is shown unadapted, in its own colour.
Mat3 xyzToRec709(const Vec3& white);

}  // namespace parhelion
