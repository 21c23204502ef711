// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/camera_settings.h"

namespace parhelion {

// How a panorama (sky/projection.h) closes upon itself.

/// Angle that a pixel of a panorama spans, rad.
double radiansPerPixel(const CameraSettings& camera);

/// Whether a picture is a panorama that closes to a full turn from its left edge to its right one.
bool isFullTurn(const CameraSettings& camera);

/// Whether a panorama shows the sky from one pole of its frame to the other.
bool reachesPoles(const CameraSettings& camera);

}  // namespace parhelion
