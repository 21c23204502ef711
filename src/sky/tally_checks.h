// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/tally.h"

namespace parhelion {

/// Throws std::invalid_argument with what it has found and what it should be, where no run can have made a tally: sums
/// below 0, halves larger than the whole, more light than was intercepted, hits that do not fit the light or the rays.
/// A file whose checksums fit may still hold such sums, if another program has made it.
void requirePlausible(const Tally& tally);

/// The same for SkyTally::Shared.
void requirePlausibleShared(const Tally& shared);

}  // namespace parhelion
