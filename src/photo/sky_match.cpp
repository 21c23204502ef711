// SPDX-License-Identifier: Apache-2.0
#include "photo/sky_match.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "math/rotation.h"
#include "picture/colour_space.h"

namespace parhelion {
namespace {

/// Every so manieth pixel in both directions is looked at: a quarter of a million of them say enough.
int stepFor(int width, int height) {
  constexpr double kEnough = 250000.0;
  return std::max(1, static_cast<int>(std::sqrt(static_cast<double>(width) * height / kEnough)));
}

/// Whether the camera had no more to say than that it is as bright as can be.
bool isClipped(const Samples& samples, std::size_t i) {
  return std::visit(
      [i](const auto& all) {
        using Sample = std::decay_t<decltype(all[i])>;
        if constexpr (std::is_floating_point_v<Sample>) return !std::isfinite(all[i]);
        return all[i] == std::numeric_limits<Sample>::max();
      },
      samples);
}

struct Mean {
  Vec3 sum{0.0};
  std::size_t pixels = 0;
};

}  // namespace

SkyTone skyTone(const Photograph& photograph, const SkyMask& mask, const CameraSettings& settings,
                double sunElevation) {
  const Camera camera(settings);
  const Vec3 toSun = skyDirection(0.0, sunElevation);
  const double nearSun = std::cos(kSkyAroundSun);
  Mean all, around;
  const int step = stepFor(mask.width, mask.height);
  for (int y = 0; y < mask.height; y += step) {
    for (int x = 0; x < mask.width; x += step) {
      const std::size_t pixel = static_cast<std::size_t>(y) * mask.width + x;
      if (mask.sky[pixel] < 255) continue;
      Vec3 rgb;
      bool clipped = false;
      for (int c = 0; c < 3; ++c) {
        const std::size_t i = pixel * photograph.channels + c;
        rgb[c] = linearAt(photograph.samples, i);
        clipped |= isClipped(photograph.samples, i);
      }
      if (clipped) continue;
      all.sum += rgb;
      ++all.pixels;
      const auto toSky = camera.toSky({x + 0.5, y + 0.5});
      if (!toSky || glm::dot(*toSky, toSun) < nearSun) continue;
      around.sum += rgb;
      ++around.pixels;
    }
  }
  SkyTone tone;
  tone.aroundSun = around.pixels > 0 && around.pixels >= all.pixels / 100;
  const Mean& mean = tone.aroundSun ? around : all;
  tone.luminance = mean.pixels > 0 ? glm::dot(mean.sum, kRec709Luminance) / static_cast<double>(mean.pixels) : 0.0;
  if (!(tone.luminance > 0.0))
    throw std::invalid_argument(
        "the sky has no brightness to be measured: it is masked, black or clipped; give --strength, or another --mask");
  tone.colour = mean.sum / (static_cast<double>(mean.pixels) * tone.luminance);
  return tone;
}

double brightHalo(const HaloLookup& halo, const SkyMask& mask) {
  std::vector<double> luminances;
  const int step = stepFor(mask.width, mask.height);
  for (int y = 0; y < mask.height; y += step) {
    for (int x = 0; x < mask.width; x += step) {
      if (mask.sky[static_cast<std::size_t>(y) * mask.width + x] < 255) continue;
      const auto light = halo.at({x + 0.5, y + 0.5});
      luminances.push_back(light ? glm::dot(*light, kRec709Luminance) : 0.0);
    }
  }
  if (luminances.empty()) return 0.0;
  const auto place = luminances.begin() + static_cast<std::ptrdiff_t>(luminances.size() * 99 / 100);
  std::nth_element(luminances.begin(), place, luminances.end());
  return *place;
}

HaloStrength haloStrength(const HaloStrengthSettings& settings, const Photograph& photograph, const SkyMask& mask,
                          const CameraSettings& camera, double sunElevation, const HaloLookup& halo) {
  std::optional<SkyTone> sky;
  if (!settings.strength || !settings.white) sky = skyTone(photograph, mask, camera, sunElevation);
  Vec3 white = settings.white ? *settings.white : sky->colour;
  white /= glm::dot(white, kRec709Luminance);
  if (settings.strength) return {*settings.strength * white, {}};

  double strength = 0.0;
  std::vector<std::string> remarks;
  const double bright = brightHalo(halo, mask);
  if (bright == 0.0) remarks.emplace_back("there is no halo in the photograph's sky");
  if (bright > 0.0) strength = settings.contrast * sky->luminance / bright;
  char text[200];
  std::snprintf(text, sizeof text,
                "strength: %g, by which the halo's bright parts have %g of the luminance of the sky%s", strength,
                settings.contrast, sky->aroundSun ? " around the sun" : "");
  remarks.emplace_back(text);
  return {strength * white, remarks};
}

}  // namespace parhelion
