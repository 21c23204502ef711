// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "picture/photograph.h"

namespace parhelion {

/// Turns a picture stored under an Exif orientation (CIPA DC-008, tag 0x0112: 1 upright, 2 mirrored left to right, 3
/// turned by 180 degrees, 4 mirrored top to bottom, 5 transposed, 6 to be turned clockwise, 7 transposed about the
/// other diagonal, 8 to be turned counter-clockwise) upright. Takes the samples twice for a moment, unless it is 1.
void turnUpright(Photograph& photograph, int orientation);

}  // namespace parhelion
