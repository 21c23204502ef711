// SPDX-License-Identifier: Apache-2.0
#include "picture/tone.h"

#include <algorithm>
#include <cmath>

#include "math/portable.h"
#include "picture/gamut.h"

namespace parhelion {
namespace {

constexpr double kHighlightFade = 128.0;  // exposed value at which a colour is half way to white

bool isFinite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// Thresholds of an 8 x 8 ordered dither (Bayer 1973), in (-1/2, 1/2) of a step, by interleaving the bits of x ^ y
/// and y.
double ditherThreshold(int x, int y) {
  int rank = 0;
  for (int bit = 0; bit < 3; ++bit) {
    rank = rank * 4 + (((x ^ y) >> bit) & 1) * 2 + ((y >> bit) & 1);
  }
  return (rank + 0.5) / 64.0 - 0.5;
}

}  // namespace

Vec3 toneCurve(const Vec3& exposed) {
  if (!isFinite(exposed)) return {0.0, 0.0, 0.0};
  const Vec3 colour = intoGamut(exposed);
  const double norm = std::max({colour.x, colour.y, colour.z});
  if (norm <= 0.0) return {0.0, 0.0, 0.0};

  const double peak = norm < 1.0 ? norm / (1.0 + norm) : 1.0 - 1.0 / (1.0 + norm);  // never falls in its last bit
  const double fade = norm / kHighlightFade;
  const double towardWhite = fade < 1.0 ? fade * fade / (1.0 + fade * fade) : 1.0 / (1.0 + 1.0 / fade / fade);
  const Vec3 saturated = colour / norm;
  return peak * (saturated + towardWhite * (Vec3(1.0) - saturated));
}

std::uint8_t ditheredStep(double encoded, int x, int y) {
  const double step = std::floor(encoded * 255.0 + ditherThreshold(x, y) + 0.5);
  return static_cast<std::uint8_t>(std::clamp(step, 0.0, 255.0));
}

Preview developPreview(const Image& image, const ToneSettings& settings) {
  const auto [red, green, blue] = image.rgb();
  const double exposure = portable::exp(settings.exposureStops * portable::log(2.0));
  Preview preview{image.width, image.height, std::vector<std::uint8_t>(3 * image.pixels()), 0};
  for (std::size_t i = 0; i < image.pixels(); ++i) {
    const Vec3 radiance{(*red)[i], (*green)[i], (*blue)[i]};
    if (!isFinite(radiance)) ++preview.badPixels;
    const Vec3 display = toneCurve(exposure * radiance);
    const int x = static_cast<int>(i % static_cast<std::size_t>(image.width));
    const int y = static_cast<int>(i / static_cast<std::size_t>(image.width));
    for (int c = 0; c < 3; ++c) {
      preview.rgb[3 * i + static_cast<std::size_t>(c)] = ditheredStep(srgbEncode(display[c]), x, y);
    }
  }
  return preview;
}

}  // namespace parhelion
