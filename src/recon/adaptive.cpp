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
  Grid<Light<N>> light(band.width(), band.height());
  forRows(band.height(), [&](int y) {
    for (int x = 0; x < band.width(); ++x) {
      const std::size_t pixel = band.pixelAt(x, y);
      if (from.solidAngles()[pixel] <= 0.0) continue;
      const SkyLight::Pixel here = from.at(pixel);
      light.at(x, y)[0] = static_cast<float>(here.luminance);
      light.at(x, y)[1] = static_cast<float>(here.difference);
      if constexpr (N == 4) {
        light.at(x, y)[2] = static_cast<float>(here.x);
        light.at(x, y)[3] = static_cast<float>(here.z);
      }
    }
  });
  return light;
}

/// What turns filtered hits into radiance so that all light is kept.
template <std::size_t N>
double keepingAllLight(const Grid<Light<N>>& filtered, const GuardBand& band, const SkyLight& from) {
  const int width = from.tally().width();
  const double sum = sumOverRows(from.tally().height(), [&](int y) {
    double row = 0.0;
    for (int x = 0; x < width; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y) * width + x;
      row += static_cast<double>(filtered[band.cellOf(pixel)][0]) * from.solidAngles()[pixel];
    }
    return row;
  });
  return from.light() / (from.tally().info.interceptedLight() * sum);
}

template <std::size_t N>
Image reconstructed(const SkyLight& from, const Watch& watch) {
  const GuardBand band(from.tally().info.camera);
  const SkyPyramid sky(band.width(), band.height(), solidAngles(from, band), band.frame());
  const Grid<Light<N>> filtered = adaptiveFilter<N>(sky, lightOf<N>(from, band), from.hits(), watch);

  const Mat3 toRgb = xyzToRec709(from.tally().info.white);
  const auto at = [&](std::size_t pixel, std::size_t c) {
    return static_cast<double>(filtered[band.cellOf(pixel)][c]);
  };
  FilteredLight light;
  light.luminance = [&](std::size_t pixel) { return at(pixel, 0); };
  light.difference = [&](std::size_t pixel) { return at(pixel, 1); };
  light.rgb = [&](std::size_t pixel) {
    return N == 4 ? toRgb * Vec3(at(pixel, N - 2), at(pixel, 0), at(pixel, N - 1)) : Vec3(at(pixel, 0));
  };
  light.hitsPerPixel = [&](std::size_t pixel) {
    return at(pixel, 0) * static_cast<double>(sky.wholeOmega()[band.cellOf(pixel)]);
  };
  return developed(from.tally().width(), from.tally().height(), light, keepingAllLight(filtered, band, from));
}

}  // namespace

Image adaptiveRadiance(const Tally& tally, const Watch& watch) {
  const SkyLight light(tally);
  if (light.hitsPerLight() <= 0.0) return emptyRadiance(tally.width(), tally.height());
  return tally.colours() == 1 ? reconstructed<2>(light, watch) : reconstructed<4>(light, watch);
}

}  // namespace parhelion
