// SPDX-License-Identifier: Apache-2.0
#include "photo/sky_match.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <type_traits>
#include <vector>

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

/// A photograph's sky in points of a grid.
struct SkyPoints {
  int width = 0, height = 0;
  std::vector<Vec3> light;             // linear
  std::vector<double> luminance;       // infinite where it is not a number
  std::vector<std::uint8_t> measured;  // 1: all sky, and not clipped
  std::vector<std::uint8_t> aroundSun;

  std::size_t size() const { return light.size(); }
};

SkyPoints skyPoints(const Photograph& photograph, const SkyMask& mask, const Camera& camera, const Vec3& toSun) {
  const double nearSun = std::cos(kSkyAroundSun);
  const int step = stepFor(mask.width, mask.height);
  SkyPoints points;
  points.width = (mask.width + step - 1) / step;
  points.height = (mask.height + step - 1) / step;
  for (int y = 0; y < mask.height; y += step) {
    for (int x = 0; x < mask.width; x += step) {
      const std::size_t pixel = static_cast<std::size_t>(y) * mask.width + x;
      const bool isSky = mask.sky[pixel] == 255;
      Vec3 rgb;
      bool clipped = false;
      for (int c = 0; c < 3; ++c) {
        const std::size_t i = pixel * photograph.channels + c;
        rgb[c] = linearAt(photograph.samples, i);
        clipped |= isClipped(photograph.samples, i);
      }
      const double luminance = glm::dot(rgb, kRec709Luminance);
      const auto toSky = camera.toSky({x + 0.5, y + 0.5});
      points.light.push_back(rgb);
      points.luminance.push_back(!isSky                     ? 0.0
                                 : std::isfinite(luminance) ? luminance
                                                            : std::numeric_limits<double>::infinity());
      points.measured.push_back(isSky && !clipped);
      points.aroundSun.push_back(toSky && glm::dot(*toSky, toSun) >= nearSun);
    }
  }
  return points;
}

/// The luminance that half of the measured points have; 0 without any.
double medianLuminance(const SkyPoints& points) {
  std::vector<double> all;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points.measured[i]) all.push_back(points.luminance[i]);
  if (all.empty()) return 0.0;
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  return *middle;
}

/// Leaves out what is no sky but a source of light, the sun's disc or a lamp: what is far brighter than most of the
/// sky, and the glare about it.
void leaveOutLamps(SkyPoints& points) {
  // Clouds in front of a dark sky are up to ten times as bright. Glare ends where the sky is about as bright as it.
  constexpr double kLamp = 10.0, kGlare = 2.0;
  const double sky = medianLuminance(points);
  if (!(sky > 0.0)) return;
  std::vector<std::uint8_t> bright(points.size(), 0);
  std::vector<std::size_t> toSpread;
  const auto take = [&](std::size_t i) {
    if (bright[i]) return;
    bright[i] = 1;
    points.measured[i] = 0;
    toSpread.push_back(i);
  };
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points.luminance[i] > kLamp * sky) take(i);
  while (!toSpread.empty()) {
    const int x = static_cast<int>(toSpread.back() % points.width),
              y = static_cast<int>(toSpread.back() / points.width);
    toSpread.pop_back();
    for (int v = std::max(0, y - 1); v <= std::min(points.height - 1, y + 1); ++v) {
      for (int u = std::max(0, x - 1); u <= std::min(points.width - 1, x + 1); ++u) {
        const std::size_t i = static_cast<std::size_t>(v) * points.width + u;
        if (points.luminance[i] > kGlare * sky) take(i);
      }
    }
  }
}

/// Keeps the points around the sun where they are enough to tell of the sky; says whether.
bool keepAroundSun(SkyPoints& points) {
  std::size_t all = 0, around = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    all += points.measured[i];
    around += points.measured[i] & points.aroundSun[i];
  }
  if (around == 0 || around < all / 100) return false;
  for (std::size_t i = 0; i < points.size(); ++i) points.measured[i] &= points.aroundSun[i];
  return true;
}

}  // namespace

SkyTone skyTone(const Photograph& photograph, const SkyMask& mask, const CameraSettings& settings,
                double sunElevation) {
  SkyPoints points = skyPoints(photograph, mask, Camera(settings), skyDirection(0.0, sunElevation));
  SkyTone tone;
  tone.aroundSun = keepAroundSun(points);
  leaveOutLamps(points);
  Vec3 sum(0.0);
  std::size_t pixels = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!points.measured[i]) continue;
    sum += points.light[i];
    ++pixels;
  }
  tone.luminance = pixels > 0 ? glm::dot(sum, kRec709Luminance) / static_cast<double>(pixels) : 0.0;
  if (!(tone.luminance > 0.0))
    throw std::invalid_argument(
        "the sky has no brightness to be measured: it is masked, black or clipped; give --strength, or another --mask");
  tone.colour = sum / (static_cast<double>(pixels) * tone.luminance);
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
