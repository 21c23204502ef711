// SPDX-License-Identifier: Apache-2.0
#include "view/palette.h"

namespace parhelion {

// The families' colours differ in lightness, too, so that they can be told apart by eyes that see two primaries alone.

const Palette kOnSky{.shadow = {0.0, 0.02, 0.06, 0.45},
                     .textShadow = {0.0, 0.02, 0.06, 0.72},
                     .grid = {1.0, 1.0, 1.0, 0.42},
                     .below = {1.0, 1.0, 1.0, 0.24},
                     .horizon = {0.90, 0.78, 0.62, 0.9},
                     .circle = {1.0, 1.0, 1.0, 0.75},
                     .sun = {1.0, 0.95, 0.75, 1.0},
                     .plates = {1.0, 0.50, 0.68, 0.9},
                     .columns = {0.42, 0.92, 0.52, 0.9},
                     .parry = {1.0, 0.64, 0.20, 0.9},
                     .lowitz = {0.76, 0.62, 1.0, 0.9},
                     .random = {0.40, 0.80, 1.0, 0.9},
                     .pyramids = {0.97, 0.94, 0.42, 0.9}};

const Palette kOnPaper{.shadow = {1.0, 1.0, 1.0, 0.75},
                       .textShadow = {1.0, 1.0, 1.0, 0.85},
                       .grid = {0.0, 0.0, 0.0, 0.30},
                       .below = {0.0, 0.0, 0.0, 0.18},
                       .horizon = {0.45, 0.30, 0.15, 0.9},
                       .circle = {0.25, 0.25, 0.25, 0.75},
                       .sun = {0.55, 0.40, 0.0, 1.0},
                       .plates = {0.78, 0.06, 0.38, 0.9},
                       .columns = {0.0, 0.48, 0.16, 0.9},
                       .parry = {0.80, 0.36, 0.0, 0.9},
                       .lowitz = {0.46, 0.18, 0.80, 0.9},
                       .random = {0.0, 0.36, 0.76, 0.9},
                       .pyramids = {0.50, 0.44, 0.0, 0.9}};

Colour Palette::of(HaloFamily family) const {
  switch (family) {
    case HaloFamily::plates:
      return plates;
    case HaloFamily::columns:
      return columns;
    case HaloFamily::parry:
      return parry;
    case HaloFamily::lowitz:
      return lowitz;
    case HaloFamily::random:
      return random;
    case HaloFamily::pyramids:
      return pyramids;
  }
  return circle;
}

std::string legendText(HaloFamily family) {
  switch (family) {
    case HaloFamily::plates:
      return "plates";
    case HaloFamily::columns:
      return "columns";
    case HaloFamily::parry:
      return "Parry columns";
    case HaloFamily::lowitz:
      return "Lowitz plates";
    case HaloFamily::random:
      return "prisms, all ways";
    case HaloFamily::pyramids:
      return "pyramids, all ways";
  }
  return {};
}

}  // namespace parhelion
