// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "math/conventions.h"
#include "sky/distortion.h"
#include "sky/horizon.h"
#include "sky/projection.h"

namespace parhelion {

/// Which extent of the image `fieldOfView` is measured along.
enum class FieldOfViewAxis { horizontal, vertical, diagonal };

/// How far the picture lies beside the optical axis, as behind a lens for perspective control: the axis meets the film
/// that many focal lengths to the left of the picture's centre (x) and below it (y).
struct Shift {
  double x = 0.0, y = 0.0;  // focal lengths, to the right and up

  bool operator==(const Shift&) const = default;
};

struct CameraSettings {
  Projection projection = Projection::fisheyeEqualArea;
  double azimuth = 0.0;          // rad, of the optical axis, from the sun
  double elevation = 0.5 * kPi;  // rad, of the optical axis
  double roll = 0.0;             // rad, clockwise turn of the camera as its user sees it
  FieldOfViewAxis fieldOfViewAxis = FieldOfViewAxis::horizontal;
  double fieldOfView = kPi;  // rad, from border to border of the image
  double imageCircle = 0.0;  // rad, full angle a fisheye lens covers; 0: the larger of pi and the field of view
  Distortion distortion;     // of a lens that is not ideal; never of an equirectangular picture
  Shift shift;               // of the picture beside the axis of a single lens
  Horizon horizon = Horizon::keep;
  int width = 1024;   // pixels
  int height = 1024;  // pixels

  bool operator==(const CameraSettings&) const = default;
};

}  // namespace parhelion
