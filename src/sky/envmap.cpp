// SPDX-License-Identifier: Apache-2.0
#include "sky/envmap.h"

#include <cmath>

#include "sky/full_turn.h"

namespace parhelion {

Envmap envmapOf(const Camera& camera) {
  constexpr double kRounding = 1e-9;  // rad; far more than that of an angle in degrees, far less than a pixel
  const CameraSettings& s = camera.settings();
  const bool isLevel = std::abs(s.elevation) < kRounding && std::abs(s.roll) < kRounding;
  const bool isWhole = isFullTurn(s) && s.width == 2 * s.height;
  return isLevel && isWhole ? Envmap::latLong : Envmap::none;
}

}  // namespace parhelion
