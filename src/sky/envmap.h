// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "picture/envmap.h"
#include "sky/camera.h"

namespace parhelion {

/// A level picture of the whole sphere, twice as wide as high, is what lighting programs call a latitude-longitude map.
Envmap envmapOf(const Camera& camera);

}  // namespace parhelion
