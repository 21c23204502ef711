// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sky/camera_settings.h"

namespace parhelion {

/// A part of a picture that is a picture itself, of all its height: what lies on the other side of its border is not
/// its neighbour in the sky.
struct PicturePart {
  CameraSettings camera;
  int left;  // column at which it begins
};

/// The two hemispheres of a dual fisheye, as pictures of ordinary fisheyes; of any other camera the whole picture.
std::vector<PicturePart> partsOf(const CameraSettings& camera);

}  // namespace parhelion
