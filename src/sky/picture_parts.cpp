// SPDX-License-Identifier: Apache-2.0
#include "sky/picture_parts.h"

#include "sky/projections.h"

namespace parhelion {

std::vector<PicturePart> partsOf(const CameraSettings& camera) {
  return visitProjection(camera.projection, [&](auto facts) -> std::vector<PicturePart> {
    if constexpr (facts.discs == 1) {
      return {{camera, 0}};
    } else {
      CameraSettings front = camera;
      front.projection = facts.ofDisc;
      front.width = camera.width / 2;
      front.imageCircle = kPi;
      front.fieldOfView = kPi;
      front.fieldOfViewAxis = front.width <= front.height ? FieldOfViewAxis::horizontal : FieldOfViewAxis::vertical;
      // Half a turn about the camera's up.
      CameraSettings back = front;
      back.azimuth = camera.azimuth + kPi;
      back.elevation = -camera.elevation;
      back.roll = -camera.roll;
      return {{front, 0}, {back, front.width}};
    }
  });
}

}  // namespace parhelion
