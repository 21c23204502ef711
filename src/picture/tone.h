// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "math/conventions.h"
#include "picture/image.h"
#include "picture/transfer.h"

namespace parhelion {

struct ToneSettings {
  double exposureStops = 0.0;  // the radiance is multiplied by 2^stops; 1 then comes out at half of white
};

/// Exposed linear Rec.709 to display-linear Rec.709 in [0, 1]: colours out of gamut are mixed with the grey of their
/// luminance just as far as needed, the largest component goes through x / (1 + x) and the others in proportion, so
/// that hues stay. That keeps bright parts apart: 1.1 and 13 are 75 and 97 % of the code values of sRGB. Far highlights
/// fade to white, half way at 128. Black for components that are not finite.
Vec3 toneCurve(const Vec3& exposed);

/// 8 bits of an encoded component in [0, 1] at a place of the picture, by ordered dither: gradients of a halo on black
/// would show bands without it. Whole steps, black and white among them, stay what they are.
std::uint8_t ditheredStep(double encoded, int x, int y);

/// An sRGB picture of 8 bits a component, row-major RGB triples.
struct Preview {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
  std::size_t badPixels = 0;  // not finite in the image, black here
};

/// Exposure, tone curve and transfer function for each pixel of the channels R, G, B. Throws std::invalid_argument if
/// one is missing.
Preview developPreview(const Image& image, const ToneSettings& settings);

}  // namespace parhelion
