// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "image/camera.h"

namespace parhelion {

/// What an EXR file says of itself by the standard attribute `envmap`.
enum class Envmap { none, latLong };

/// A level picture of the whole sphere, twice as wide as high, is what lighting programs call a latitude-longitude map.
Envmap envmapOf(const Camera& camera);

}  // namespace parhelion
