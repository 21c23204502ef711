// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "picture/image.h"
#include "picture/tone.h"

namespace parhelion {

/// The exposure, in stops, at which the lines and edges of a linear picture can be told from each other.
///
/// It goes by where the picture changes, not by how bright it is on the whole. Every pixel counts by how much its
/// lightness (the cube root of its luminance, as in CIE L*) differs from that of its right and lower neighbours. Three
/// quarters of all this change lie in pixels darker than a certain luminance. The exposure brings that luminance to
/// 2^-3. On the tone curve (tone.h) it then is a dark grey of 37 % of the code values, and thirty times as much light
/// is still clearly below white.
///
/// The brightest hundredth of the lit pixels counts as equally bright, so that the sun's disc does not decide. Pixels
/// without light, or that are not finite, do not count; they are the corners around an image circle and the ground. In
/// a picture where nothing changes, every lit pixel counts alike. 0 for a picture that is black all over. Throws
/// std::invalid_argument if R, G or B is missing.
double autoExposure(const Image& image);

/// How a linear picture is to be developed.
struct LightDisplay {
  std::optional<double> exposure = std::nullopt;       // stops; none: autoExposure()
  std::optional<double> exposureValue = std::nullopt;  // in its place, EV at ISO 100
  ToneCurve curve = ToneCurve::reinhard;
};

/// The exposure and the curve for a picture. Throws std::invalid_argument for an exposure value if it is not known of
/// which luminance (cd/m^2) its R = G = B = 1 is.
ToneSettings toneFor(const LightDisplay& how, const Image& image, std::optional<double> whiteLuminance);

/// The exposure, in stops, of a picture that is bright all over, as a camera would choose it: half of the lit pixels
/// are then brighter than a grey of 55 % of the code values. Throws as autoExposure() does, and is 0 where that is.
double exposureOfScenery(const Image& image);

}  // namespace parhelion
