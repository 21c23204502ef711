// SPDX-License-Identifier: Apache-2.0
#include "recon/adaptive.h"

#include "image/colour_space.h"
#include "recon/adaptive_filter.h"
#include "recon/guard_band.h"
#include "recon/sky_light.h"

namespace parhelion {
namespace {

std::vector<double> solidAngles(const SkyLight& from, const GuardBand& band) {
  std::vector<double> result;
  result.reserve(static_cast<std::size_t>(band.width()) * band.height());
  for (int y = 0; y < band.height(); ++y) {
    for (int x = 0; x < band.width(); ++x) result.push_back(from.solidAngles()[band.pixelAt(x, y)]);
  }
  return result;
}

template <std::size_t N>
Grid<Light<N>> lightOf(const SkyLight& from, const GuardBand& band) {
  const Vec3 white = from.tally().info.white;
  Grid<Light<N>> light(band.width(), band.height());
  forRows(band.height(), [&](int y) {
    for (int x = 0; x < band.width(); ++x) {
      const std::size_t pixel = band.pixelAt(x, y);
      if (from.solidAngles()[pixel] <= 0.0) continue;
      const SkyLight::Pixel here = from.at(pixel);
      light.at(x, y)[0] = static_cast<float>(here.luminance);
      light.at(x, y)[1] = static_cast<float>(here.difference);
      if constexpr (N == 4) {
        light.at(x, y)[2] = static_cast<float>(white.x > 0.0 ? here.x / white.x : 0.0);
        light.at(x, y)[3] = static_cast<float>(white.z > 0.0 ? here.z / white.z : 0.0);
      }
    }
  });
  return light;
}

/// What turns filtered hits into radiance so that all light is kept.
double keepingAllLight(const Grid<Light<2>>& luminance, const GuardBand& band, const SkyLight& from) {
  const int width = from.tally().width();
  const double sum = sumOverRows(from.tally().height(), [&](int y) {
    double row = 0.0;
    for (int x = 0; x < width; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y) * width + x;
      row += static_cast<double>(luminance[band.cellOf(pixel)][0]) * from.solidAngles()[pixel];
    }
    return row;
  });
  return from.light() / (from.tally().info.interceptedLight() * sum);
}

template <std::size_t N>
Image reconstructed(const SkyLight& from, const Watch& watch) {
  const GuardBand band(from.tally().info.camera);
  const SkyPyramid sky(band.width(), band.height(), solidAngles(from, band), band.frame());
  const Filtered filtered = adaptiveFilter<N>(sky, lightOf<N>(from, band), from.hits(), watch);

  const Vec3 white = from.tally().info.white;
  const Mat3 toRgb = xyzToRec709(white);
  const auto luminanceAt = [&](std::size_t pixel) { return filtered.luminance[band.cellOf(pixel)]; };
  FilteredLight light;
  light.luminance = [&](std::size_t pixel) { return static_cast<double>(luminanceAt(pixel)[0]); };
  light.difference = [&](std::size_t pixel) { return static_cast<double>(luminanceAt(pixel)[1]); };
  light.rgb = [&](std::size_t pixel) {
    const auto luminance = static_cast<double>(luminanceAt(pixel)[0]);
    if (N == 2) return Vec3(luminance);
    const auto [y, x, z] = filtered.colour[band.cellOf(pixel)];
    if (!(y > 0.0F)) return Vec3(luminance);
    return luminance * (toRgb * Vec3(white.x * static_cast<double>(x / y), 1.0, white.z * static_cast<double>(z / y)));
  };
  light.hitsPerPixel = [&](std::size_t pixel) {
    return static_cast<double>(luminanceAt(pixel)[0] * sky.wholeOmega()[band.cellOf(pixel)]);
  };
  return developed(from.tally().width(), from.tally().height(), light, keepingAllLight(filtered.luminance, band, from));
}

}  // namespace

Image adaptiveRadiance(const Tally& tally, const Watch& watch) {
  const SkyLight light(tally);
  if (light.hitsPerLight() <= 0.0) return emptyRadiance(tally.width(), tally.height());
  return tally.colours() == 1 ? reconstructed<2>(light, watch) : reconstructed<4>(light, watch);
}

}  // namespace parhelion
