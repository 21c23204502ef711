// SPDX-License-Identifier: Apache-2.0
#include "parallel/loops.h"
#include "picture/colour_space.h"
#include "recon/adaptive/adaptive_filter.h"
#include "recon/adaptive/guard_band.h"
#include "recon/methods.h"
#include "recon/sky_light.h"
#include "sky/radiance.h"

#include <algorithm>
#include <cmath>

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

/// X, Y and Z relative to white.
Vec3 perWhite(const Vec3& xyz, const Vec3& white) {
  return {white.x > 0.0 ? xyz.x / white.x : 0.0, xyz.y, white.z > 0.0 ? xyz.z / white.z : 0.0};
}

template <std::size_t N>
Raster<Light<N>> lightOf(const SkyLight& from, const GuardBand& band) {
  Raster<Light<N>> light(band.width(), band.height());
  forRows(band.height(), [&](int y) {
    for (int x = 0; x < band.width(); ++x) {
      const std::size_t pixel = band.pixelAt(x, y);
      if (from.solidAngles()[pixel] <= 0.0) continue;
      const SkyLight::Pixel here = from.at(pixel);
      light.at(x, y)[0] = static_cast<float>(here.luminance);
      light.at(x, y)[1] = static_cast<float>(here.difference);
      if constexpr (N == 4) {
        const Vec3 xyz = perWhite({here.x, here.luminance, here.z}, from.tally().info.white);
        light.at(x, y)[2] = static_cast<float>(xyz.x);
        light.at(x, y)[3] = static_cast<float>(xyz.z);
      }
    }
  });
  return light;
}

/// What comes out of the filter, by the picture's pixels.
class FilteredPixels {
 public:
  FilteredPixels(Filtered filtered, const GuardBand& band) : filtered_(std::move(filtered)), band_(band) {}

  double luminance(std::size_t pixel) const { return static_cast<double>(at(pixel)[0]); }
  double difference(std::size_t pixel) const { return static_cast<double>(at(pixel)[1]); }

  double leastError(std::size_t pixel) const { return static_cast<double>(filtered_.leastError[band_.cellOf(pixel)]); }
  double bias(std::size_t pixel) const { return static_cast<double>(filtered_.bias[band_.cellOf(pixel)]); }

  /// X, Y and Z relative to white: the luminance in the ratios of the colour.
  Vec3 colour(std::size_t pixel) const {
    const double y = luminance(pixel);
    if (filtered_.colour.size() == 0) return Vec3(y);
    const Light<3>& c = filtered_.colour[band_.cellOf(pixel)];
    return c[0] > 0.0F ? y * Vec3(static_cast<double>(c[1] / c[0]), 1.0, static_cast<double>(c[2] / c[0])) : Vec3(y);
  }

 private:
  const Light<2>& at(std::size_t pixel) const { return filtered_.luminance[band_.cellOf(pixel)]; }

  Filtered filtered_;
  const GuardBand& band_;
};

/// What X, Y and Z must be multiplied by so that all light of each is kept, in radiance.
Vec3 keepingAllLight(const FilteredPixels& pixels, const SkyLight& from) {
  const int width = from.tally().width();
  const auto sumOver = [&](const auto& light) {
    return sumOverRows(from.tally().height(), [&](int y) {
      Vec3 row(0.0);
      for (int x = 0; x < width; ++x) {
        const std::size_t pixel = static_cast<std::size_t>(y) * width + x;
        if (from.solidAngles()[pixel] > 0.0) row += light(pixel);
      }
      return row;
    });
  };
  const Vec3 given = sumOver([&](std::size_t pixel) {
    const SkyLight::Pixel light = from.at(pixel);
    return perWhite({light.x, light.luminance, light.z}, from.tally().info.white);
  });
  const Vec3 kept = sumOver([&](std::size_t pixel) { return from.solidAngles()[pixel] * pixels.colour(pixel); });
  Vec3 scale(1.0 / (from.hitsPerLight() * from.tally().info.interceptedLight()));
  for (int c = 0; c < 3; ++c) scale[c] *= kept[c] > 0.0 && given[c] > 0.0 ? given[c] / kept[c] : given.y / kept.y;
  return scale;
}

/// What a pixel's own light says of the bias there, in effective hits. A mean over a window is too small for single
/// pixels that stand out in it, such as the tip of an arc. Where the filtered light differs from the pixel's own by
/// more than 1.5 times the latter's noise, this is the root of what the square of the difference exceeds by.
double biasByOwnLight(const SkyLight& from, std::size_t pixel, double filteredHits) {
  constexpr double kSignificance = 1.5;
  const double own = from.at(pixel).luminance;
  const double variance =
      std::max({from.tally().squares(static_cast<int>(pixel)) * from.hitsPerLight() * from.hitsPerLight(), own, 1.0});
  return std::sqrt(
      std::max(0.0, (own - filteredHits) * (own - filteredHits) - kSignificance * kSignificance * variance));
}

template <std::size_t N>
Image reconstructed(const SkyLight& from, const Watch& watch) {
  const GuardBand band(from.tally().info.camera);
  const SkyPyramid sky(band.width(), band.height(), solidAngles(from, band), band.frame());
  const FilteredPixels pixels(adaptiveFilter<N>(sky, lightOf<N>(from, band), from.hits(), watch), band);

  const Vec3 white = from.tally().info.white;
  const Mat3 toRgb = xyzToRec709(white);
  const Vec3 keeping = keepingAllLight(pixels, from);
  const Vec3 toXyz = white * keeping / keeping.y;
  FilteredLight light;
  light.hits = from.hits();
  light.luminance = [&](std::size_t pixel) { return pixels.luminance(pixel); };
  light.difference = [&](std::size_t pixel) { return pixels.difference(pixel); };
  light.leastError = [&](std::size_t pixel) { return pixels.leastError(pixel); };
  light.bias = [&](std::size_t pixel) {
    const double omega = static_cast<double>(sky.pixels().omega[band.cellOf(pixel)]);  // relative, as the light is
    if (omega <= 0.0) return 0.0;
    return std::max(pixels.bias(pixel), biasByOwnLight(from, pixel, pixels.luminance(pixel) * omega) / omega);
  };
  light.rgb = [&](std::size_t pixel) {
    return N == 2 ? Vec3(pixels.luminance(pixel)) : toRgb * (toXyz * pixels.colour(pixel));
  };
  light.hitsPerPixel = [&](std::size_t pixel) {
    return pixels.luminance(pixel) * static_cast<double>(sky.wholeOmega()[band.cellOf(pixel)]);
  };
  return developed(from.tally().width(), from.tally().height(), light, keeping.y);
}

}  // namespace

ReconstructedSky reconstructSky(const Tally& tally, const AdaptiveSettings&, const Watch& watch) {
  const SkyLight light(tally);
  if (light.hitsPerLight() <= 0.0) {
    ReconstructedSky dark{emptyRadiance(tally.width(), tally.height()), {}};
    dark.image.add(kBiasChannel);
    return dark;
  }
  return {tally.colours() == 1 ? reconstructed<2>(light, watch) : reconstructed<4>(light, watch), {}};
}

}  // namespace parhelion
