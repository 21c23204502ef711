// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "picture/image.h"

namespace parhelion {

// Glare: light that the eye scatters on its way to the retina. CIE 146:2002, general disability glare equation: at an
// angle of t degrees from a small source that brings 1 lx to the eye there is a veil of
//   10 / t^3 + (5 / t^2 + 0.1 p / t) (1 + (A / 62.5)^4) cd/m^2,  0.1 < t < 100,
// of which the constant 0.0025 p is left out: it lights the whole sky alike, by less than a hundredth of the source.

/// An observer.
struct Eye {
  double age = 30.0;          // A, years
  double pigmentation = 0.5;  // p: 0 black eyes, 0.5 brown, 1 blue
};

/// The veil of the equation at an angle (rad), cd/m^2 a lux.
double glareVeil(double angle, const Eye& eye = {});

/// A share of light that is blurred by a Gaussian.
struct BlurredShare {
  double sigma;  // rad
  double share;
};

/// The equation as a sum of Gaussians, whose standard deviations are a half octave apart: (1 + (t / a)^2)^(-s / 2) is
/// an integral of Gaussians over their width. Below 0.1 degrees, where it does not hold, its powers of t level out, and
/// at widths of more than 40 degrees they end. What is not in these shares stays where it is.
std::vector<BlurredShare> glareOf(const Eye& eye = {});

/// A picture of linear light as an eye sees it. `pixel` is the size of a pixel on the optical axis, rad: distances in
/// the picture are taken for angles, which is right near the axis and for equidistant lenses, and off by a tenth at the
/// rim of a whole fisheye sky. All light is kept, but what leaves the picture. Channels other than R, G and B stay.
void addGlare(Image& image, double pixel, const Eye& eye = {});

/// Spreads a plane (row-major, width x height; dark outside) by Gaussians of these widths in pixels, which must rise.
/// Each is blurred in a picture reduced by a power of two in which it is 1.5 to 3 pixels wide.
void spreadLight(std::vector<float>& plane, int width, int height, std::span<const BlurredShare> inPixels);

}  // namespace parhelion
