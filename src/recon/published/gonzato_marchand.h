// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "recon/hit_map.h"
#include "recon/watch.h"

namespace parhelion {

/// The m that suits a map of so many hits, for unit gain and one lobe. Larger k need k^2 times as many.
double hitsPerSquare(double hits);

}  // namespace parhelion
