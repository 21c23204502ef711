// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "math/conventions.h"
#include "picture/image.h"
#include "picture/transfer.h"

namespace parhelion {

/// How exposed light becomes what a screen shows. All curves act on the largest component and move the others in
/// proportion, so that hues stay.
enum class ToneCurve {
  reinhard,  // x / (1 + x): bright parts stay apart, 1.1 and 13 are 75 and 97 % of the code values of sRGB
  filmic,    // dark parts and bright ones with less contrast than what is between them, as on film
  linear,    // x as it is, up to white at 1
};

constexpr std::string_view nameOf(ToneCurve curve) {
  switch (curve) {
    case ToneCurve::reinhard:
      return "reinhard";
    case ToneCurve::filmic:
      return "filmic";
    case ToneCurve::linear:
      return "linear";
  }
  return {};
}

struct ToneSettings {
  double exposureStops = 0.0;  // the radiance is multiplied by 2^stops
  ToneCurve curve = ToneCurve::reinhard;
};

/// Exposed linear Rec.709 to display-linear Rec.709 in [0, 1]: colours out of gamut are mixed with the grey of their
/// luminance just as far as needed, the largest component goes through the curve and the others in proportion. Far
/// highlights fade to white: half way at 128, and at 9 on the linear curve, which shows all up to 1 as it is. Black for
/// components that are not finite.
Vec3 toneCurve(const Vec3& exposed, ToneCurve curve = ToneCurve::reinhard);

/// The light that a curve shows as mid-grey, 18 % of white.
double midGreyOf(ToneCurve curve);

/// The exposure, in stops, at which a curve shows as mid-grey what an exposure value `ev` at ISO 100 is for, a
/// luminance of 0.125 * 2^ev cd/m^2 (ISO 2720: reflected light, calibration constant 12.5), of light whose R = G = B =
/// 1 is `whiteLuminance` cd/m^2.
double exposureFor(double ev, double whiteLuminance, ToneCurve curve);

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
