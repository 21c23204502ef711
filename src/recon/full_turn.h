// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/camera_settings.h"

namespace parhelion {

// How an equirectangular picture closes upon itself.

/// Angle that a pixel of an equirectangular picture spans, rad.
double radiansPerPixel(const CameraSettings& camera);

/// Whether a picture closes to a full turn from its left edge to its right one.
bool isFullTurn(const CameraSettings& camera);

/// Whether an equirectangular picture shows the sky from one pole of its frame to the other.
bool reachesPoles(const CameraSettings& camera);

}  // namespace parhelion
