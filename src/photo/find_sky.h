// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "photo/sky_mask.h"
#include "picture/image.h"

namespace parhelion {

/// Finds the sky in a linear picture of any exposure (channels R, G, B; made for up to a megapixel): what is connected
/// to the upper border, of other colours than the rest and parted from it by an edge. All of the picture where no such
/// border is found; none where what was found is rough, green or much darker than the rest, as no sky is. Black corners
/// of a fisheye picture are not sky. The same bits for any number of threads.
SkyMask findSky(const Image& linear);

/// The same in a photograph of any size: found in a reduced copy, then brought to full size by a guided filter, so that
/// soft and fine edges follow the photograph. Exactly 0 or 255 away from edges.
SkyMask findSky(const Photograph& photograph);

}  // namespace parhelion
