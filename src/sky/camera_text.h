// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/attribute_text.h"
#include "sky/camera_settings.h"

namespace parhelion {

/// The settings of a camera but for the picture's size, by the attributes of tallies: "camera.azimuth" and so on.
ExrAttributes textFromCamera(const CameraSettings& camera);

/// The inverse; the picture's size stays as it is in `camera`. Throws as AttributeReader does.
void readCamera(const AttributeReader& attributes, CameraSettings& camera);

}  // namespace parhelion
