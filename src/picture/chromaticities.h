// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "math/conventions.h"

namespace parhelion {

/// The x and y of a colour space's primaries and white in the CIE 1931 diagram.
struct Chromaticities {
  Vec2 red, green, blue, white;
};

inline const Chromaticities kRec709Chromaticities{{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}};

/// Those of ACEScg (Academy S-2014-004: primaries AP1, the white of ACES near D60).
inline const Chromaticities kAcesCgChromaticities{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, {0.32168, 0.33767}};

/// What speaks against taking the primaries for those of Rec.709: "" where they are within 1e-3, else "its colours have
/// the primaries ..., not sRGB's".
std::string chromaticitiesObjection(const Chromaticities& chromaticities);

/// The same of the exponent 1/gamma of a transfer function: "" for sRGB's usual stand-in 1/2.2, else "its colours are
/// linear ..., not sRGB" or "its colours have gamma ..., not sRGB's".
std::string gammaObjection(double exponent);

}  // namespace parhelion
