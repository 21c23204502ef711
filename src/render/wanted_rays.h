// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sky/ray_ranges.h"

namespace parhelion {

/// Slice `i` (from 1) of `count` equal ones of rays 0 ... rays - 1, in their order, cut between bundles. Some are empty
/// where there are fewer bundles than slices.
RayRange sliceOf(std::uint64_t rays, int bundleSize, std::uint64_t i, std::uint64_t count);

/// Throws std::invalid_argument with the nearest rays that would do unless the range starts with the first ray of a
/// bundle.
void requireBundleStart(const RayRange& range, int bundleSize);

}  // namespace parhelion
