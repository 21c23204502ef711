// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/conventions.h"
#include "sky/camera_settings.h"

namespace parhelion::test {

/// A camera with `width` x `height` pixels, all angles in degrees. By default pixels are few and large: each is a block
/// of sky whose error a tally states itself.
inline CameraSettings lookAt(Projection projection, double azimuth, double elevation, double roll, double fieldOfView,
                             int width = 24, int height = 24) {
  CameraSettings camera;
  camera.projection = projection;
  camera.azimuth = radians(azimuth);
  camera.elevation = radians(elevation);
  camera.roll = radians(roll);
  camera.fieldOfView = radians(fieldOfView);
  camera.width = width;
  camera.height = height;
  return camera;
}

}  // namespace parhelion::test
