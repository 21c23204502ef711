// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "beam/sky_integral.h"

namespace parhelion {

/// The light of rings of equal angle about a point of the sun, per surface of the crystals (their mean shadows).
struct RingIntegral {
  std::vector<Tristimulus> light;
  std::vector<double> error;  // of Y; those of neighbouring rings go together
  SheetTotals totals;
  long directions = 0;  // traced
  bool reached = false;
};

/// Integrates the light of randomly oriented crystals: of a scene its prisms and its light count. The same bits for any
/// number of threads.
RingIntegral integrateRings(const AxisScene& scene, const SkyAccuracy& accuracy, int rings);

}  // namespace parhelion
