// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/tally.h"

namespace parhelion::bench {

/// The same light in pixels `factor` times as wide and as high, which must divide the picture's sides. Squares are
/// added up as if no ray had met two of the pixels that become one.
Tally coarser(const Tally& tally, int factor);

}  // namespace parhelion::bench
