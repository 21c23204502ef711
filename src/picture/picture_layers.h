// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "picture/image.h"

namespace parhelion {

/// The layers of a picture, as compositors read them: a layer NAME has the channels NAME.R, NAME.G and NAME.B.
std::vector<std::string> layersOf(const Image& image);

/// Takes the channels of all layers out of a picture, which keeps the others.
Image takeLayers(Image& image);

/// A picture whose R, G, B are the sums of some of the picture's layers, without other channels. Throws
/// std::invalid_argument if it does not have one of them.
Image sumOfLayers(const Image& image, std::span<const std::string> layers);

}  // namespace parhelion
