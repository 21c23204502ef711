// SPDX-License-Identifier: Apache-2.0
#include "picture/tone.h"

#include <algorithm>
#include <cmath>

#include "math/portable.h"
#include "picture/gamut.h"

namespace parhelion {
namespace {

constexpr double kLinearFade = 8.0;       // the same of the linear curve, for which all above 1 is over-exposed
constexpr double kHighlightFade = 128.0;  // exposed value at which a colour is half way to white

constexpr double kMidGrey = 0.18;     // of white
constexpr double kFilmicWhite = 8.0;  // from somewhat below on the curve below is white

/// (a x^2 + b x) / (c x^2 + d x + e), white from x = 7.2 on: the fit of Narkowicz 2015, "ACES Filmic Tone Mapping
/// Curve", to the reference and output transforms of the Academy Color Encoding System for screens.
constexpr struct { double a = 2.51, b = 0.03, c = 2.43, d = 0.59, e = 0.14; } kFilmic;

/// What a curve makes of the largest component, above 0.
double peakOf(double x, ToneCurve curve) {
  switch (curve) {
    case ToneCurve::reinhard:
      return x < 1.0 ? x / (1.0 + x) : 1.0 - 1.0 / (1.0 + x);  // never falls in its last bit
    case ToneCurve::filmic:
      return x < kFilmicWhite
                 ? std::min(1.0, x * (kFilmic.a * x + kFilmic.b) / (x * (kFilmic.c * x + kFilmic.d) + kFilmic.e))
                 : 1.0;
    case ToneCurve::linear:
      return std::min(x, 1.0);
  }
  return 0.0;
}

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

Vec3 toneCurve(const Vec3& exposed, ToneCurve curve) {
  if (!isFinite(exposed)) return {0.0, 0.0, 0.0};
  const Vec3 colour = intoGamut(exposed);
  const double norm = std::max({colour.x, colour.y, colour.z});
  if (norm <= 0.0) return {0.0, 0.0, 0.0};

  const double peak = peakOf(norm, curve);
  const Vec3 saturated = colour / norm;
  const double fade = curve == ToneCurve::linear ? std::max(norm - 1.0, 0.0) / kLinearFade : norm / kHighlightFade;
  const double towardWhite = fade < 1.0 ? fade * fade / (1.0 + fade * fade) : 1.0 / (1.0 + 1.0 / fade / fade);
  return peak * (saturated + towardWhite * (Vec3(1.0) - saturated));
}

double midGreyOf(ToneCurve curve) {
  switch (curve) {
    case ToneCurve::reinhard:
      return kMidGrey / (1.0 - kMidGrey);
    case ToneCurve::filmic: {
      // The curve solved for its argument.
      const double a = kFilmic.a - kMidGrey * kFilmic.c, b = kFilmic.b - kMidGrey * kFilmic.d;
      return (std::sqrt(b * b + 4.0 * a * kMidGrey * kFilmic.e) - b) / (2.0 * a);
    }
    case ToneCurve::linear:
      return kMidGrey;
  }
  return kMidGrey;
}

double exposureFor(double ev, double whiteLuminance, ToneCurve curve) {
  constexpr double kLuminanceAtZero = 0.125;  // cd/m^2
  return (portable::log(midGreyOf(curve)) - portable::log(kLuminanceAtZero / whiteLuminance)) / portable::log(2.0) - ev;
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
    const Vec3 display = toneCurve(exposure * radiance, settings.curve);
    const int x = static_cast<int>(i % static_cast<std::size_t>(image.width));
    const int y = static_cast<int>(i / static_cast<std::size_t>(image.width));
    for (int c = 0; c < 3; ++c) {
      preview.rgb[3 * i + static_cast<std::size_t>(c)] = ditheredStep(srgbEncode(display[c]), x, y);
    }
  }
  return preview;
}

}  // namespace parhelion
