// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "picture/tone.h"
#include "sky/tally.h"

namespace parhelion {

inline constexpr int kMaxDotSize = 64;  // pixels

/// The plots of halo papers since Greenler, "Rainbows, Halos, and Glories" (1980): a round black dot of `size` pixels
/// across, on white, for each pixel that light of at least one ray has reached. Brightness shows as the density of
/// dots, so it needs few rays: some 10^4 to 10^5. `ink` is the dots' sRGB grey; lines over black ones are hard to see.
/// Throws std::invalid_argument unless 1 <= size <= kMaxDotSize.
Preview dots(const Tally& tally, int size = 1, std::uint8_t ink = 0);

/// Pixels across a dot that can be seen when the whole picture is looked at: 1, more from 1600 pixels a side on.
int usualDotSize(const Tally& tally);

}  // namespace parhelion
