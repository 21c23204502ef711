// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "optics/sun.h"
#include "picture/image.h"
#include "sky/camera.h"

namespace parhelion {

/// Adds the light that the crystals let pass undeviated, `share` of what they intercept, to the channels R, G, B of a
/// radiance image (1/sr): white, with the sun's disc and its limb darkening; all in one pixel for a point sun.
void drawUndeviatedSun(Image& image, const Camera& camera, const Sun& sun, double share);

/// The same for light whose colour, linear R, G, B, differs with the direction, to which unit world vectors point.
void drawSun(Image& image, const Camera& camera, const Sun& sun, const std::function<Vec3(const Vec3& toSky)>& light);

}  // namespace parhelion
