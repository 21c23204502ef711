// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "picture/image.h"
#include "sky/camera.h"

namespace parhelion {

/// Where a layer of a picture is brightest, pixel coordinates: the middle of a square of about a hundredth of its
/// shorter side. None where no square is twice as bright as the layer's mean, as then it is everywhere; squares below
/// the horizon count only if `belowHorizon`. Throws std::invalid_argument if the picture has no such layer
/// (picture/picture_layers.h).
std::optional<Vec2> brightestPlace(const Image& image, const std::string& layer, const Camera& camera,
                                   bool belowHorizon);

}  // namespace parhelion
