// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "photo/sky_mask.h"
#include "picture/photograph.h"

namespace parhelion {

/// A mask found in `small`, which is linearImage(photograph, reduction), at the size of the photograph: by the fast
/// guided filter near edges, exactly as it was elsewhere. Row by row: takes little memory but the result's.
SkyMask refineSky(const Photograph& photograph, const Image& small, const SkyMask& found, int reduction);

}  // namespace parhelion
