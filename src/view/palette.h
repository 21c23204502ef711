// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "optics/halo_makers.h"
#include "view/canvas.h"

namespace parhelion {

/// Colours of what is drawn over a picture.
struct Palette {
  Colour shadow;      // beside lines; its alpha times that of the line
  Colour textShadow;  // around letters
  Colour grid, below, horizon, circle, sun;
  Colour plates, columns, parry, lowitz, random, pyramids;

  Colour of(HaloFamily family) const;
};

/// Light lines on pictures of the sky, and dark ones on white paper.
extern const Palette kOnSky;
extern const Palette kOnPaper;

/// What a legend calls the crystals of a family.
std::string legendText(HaloFamily family);

}  // namespace parhelion
