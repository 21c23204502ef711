// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "picture/image.h"
#include "picture/raster.h"

namespace parhelion {

/// What lies outside the image circle of a fisheye lens: all that is black and connected to the corners, where all four
/// corners are black. Nothing for other pictures.
std::optional<Region> outsideImageCircle(const Image& linear);

/// The picture with the nearest colours toward its centre in place of those outside.
Image filledFromInside(const Image& linear, const Region& outside);

}  // namespace parhelion
