// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "picture/image.h"
#include "picture/tone.h"

namespace parhelion {

/// Paints a picture that has layers: each pixel in the hue of the layer that is brightest there, as bright as the whole
/// picture is at this exposure (stops). A legend to the right says which hue is which layer, in the order of `layers`;
/// what is in none of them is grey. Throws std::invalid_argument if a layer is missing.
Preview paintByLayer(const Image& image, std::span<const std::string> layers, double exposureStops);

/// The most layers that hues tell apart.
inline constexpr std::size_t kMostHues = 12;

}  // namespace parhelion
