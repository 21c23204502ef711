// SPDX-License-Identifier: Apache-2.0
#include "sky/envmap.h"

#include <cmath>

namespace parhelion {

Envmap envmapOf(const Camera& camera) {
  constexpr double kRounding = 1e-9;  // rad; far more than that of a field of view, far less than a pixel
  const CameraSettings& s = camera.settings();
  const bool isLevel = std::abs(s.elevation) < kRounding && std::abs(s.roll) < kRounding;
  const bool isWhole = s.width == 2 * s.height && std::abs(s.width / camera.focalLength() - 2.0 * kPi) < kRounding;
  return s.projection == Projection::equirectangular && isLevel && isWhole ? Envmap::latLong : Envmap::none;
}

}  // namespace parhelion
