// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "math/conventions.h"

namespace parhelion {

/// What becomes of colours that Rec.709 holds only with a negative component.
enum class Gamut {
  exact,   // they stay as they are
  clip,    // intoGamut()
  acescg,  // the picture is written in the primaries of ACEScg, in which all but the purest are positive
};

constexpr std::string_view nameOf(Gamut gamut) {
  switch (gamut) {
    case Gamut::exact:
      return "exact";
    case Gamut::clip:
      return "clip";
    case Gamut::acescg:
      return "acescg";
  }
  return {};
}

/// A linear Rec.709 colour mixed with the grey of its luminance until no component is negative: luminance and hue stay,
/// and a colour without a negative component stays to the bit. Where the luminance is not positive it is black. What is
/// not finite stays.
Vec3 intoGamut(const Vec3& colour);

}  // namespace parhelion
