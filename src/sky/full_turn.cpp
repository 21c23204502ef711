// SPDX-License-Identifier: Apache-2.0
#include "sky/full_turn.h"

#include <cmath>

namespace parhelion {
namespace {

constexpr double kRounding = 1e-9;  // rad; far more than that of a field of view, far less than a pixel

}  // namespace

double radiansPerPixel(const CameraSettings& camera) {
  return camera.fieldOfView / (camera.fieldOfViewAxis == FieldOfViewAxis::vertical ? camera.height : camera.width);
}

bool isFullTurn(const CameraSettings& camera) {
  if (!isPanorama(camera.projection)) return false;
  return std::abs(radiansPerPixel(camera) * camera.width - 2.0 * kPi) < kRounding;
}

bool reachesPoles(const CameraSettings& camera) {
  return std::abs(radiansPerPixel(camera) * camera.height - kPi) < kRounding;
}

}  // namespace parhelion
