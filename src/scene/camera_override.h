// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "sky/camera_settings.h"

namespace parhelion {

/// The override "camera={ ... }" that replaces the whole [camera] of a scene by this one; angles in it agree to 15
/// digits.
std::string cameraOverride(const CameraSettings& camera);

}  // namespace parhelion
