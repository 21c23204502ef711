// SPDX-License-Identifier: Apache-2.0
#include "recon/adaptive.h"

#include <algorithm>
#include <cmath>

#include "image/camera.h"
#include "image/colour_space.h"
#include "image/radiance.h"
#include "recon/adaptive_filter.h"
#include "recon/growing_squares.h"
#include "recon/integral_image.h"

namespace parhelion {
namespace {

/// Luminance of all of the sky: its sum and that of its squares.
struct Totals {
  double light = 0.0, squares = 0.0;

  /// Effective hits per light: with it the light of independent hits has the variance of counts.
  double hitsPerLight() const { return squares > 0.0 ? light / squares : 0.0; }
};

Totals totals(const Tally& tally, const std::vector<double>& solidAngles) {
  Totals sum;
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) {
    if (solidAngles[static_cast<std::size_t>(pixel)] <= 0.0) continue;
    sum.light += tally.luminance(pixel);
    sum.squares += tally.squares(pixel);
  }
  return sum;
}

Grid<float> firstDensity(const Tally& tally, const SkyPyramid& sky, const Totals& total) {
  Grid<std::int64_t> light(sky.width(), sky.height());
  for (std::size_t i = 0; i < light.size(); ++i) {
    if (sky.pixels().omega[i] > 0.0F) light[i] = tally.raw(static_cast<int>(i), Tally::kY);
  }
  const double perLight = total.hitsPerLight();
  const double enough = 0.5 * hitsPerKernel(total.light * perLight) / perLight;
  Grid<float> density = growingSquares(sky, light, toFixed(std::min(enough, total.light)));
  const float hitsPerUnit = static_cast<float>(fromFixed(1) * perLight);
  for (std::size_t i = 0; i < density.size(); ++i) density[i] *= hitsPerUnit;
  return density;
}

template <std::size_t N>
Grid<Light<N>> lightIn(const Tally& tally, const SkyPyramid& sky, double hitsPerLight) {
  Grid<Light<N>> light(sky.width(), sky.height());
  forRows(sky.height(), [&](int y) {
    for (int x = 0; x < sky.width(); ++x) {
      if (sky.pixels().omega.at(x, y) <= 0.0F) continue;
      const int pixel = y * sky.width() + x;
      const double all = tally.luminance(pixel);
      Light<N>& here = light.at(x, y);
      here[0] = static_cast<float>(all * hitsPerLight);
      here[1] = static_cast<float>((2.0 * tally.firstHalf(pixel) - all) * hitsPerLight);
      if constexpr (N == 4) {
        const Vec3 xyz = tally.xyz(pixel);
        here[2] = static_cast<float>(xyz.x * hitsPerLight);
        here[3] = static_cast<float>(xyz.z * hitsPerLight);
      }
    }
  });
  return light;
}

/// Variance of the luminance over its square, by the halves' difference over windows somewhat wider than the kernels.
class RelativeVariance {
 public:
  explicit RelativeVariance(const Grid<Light<2>>& luminance)
      : all_(squares(luminance, 0)), difference_(squares(luminance, 1)) {}

  double at(int x, int y, int radius) const {
    const double all = all_.square(x, y, radius);
    return all > 0.0 ? difference_.square(x, y, radius) / all : 0.0;
  }

 private:
  static IntegralImage<double> squares(const Grid<Light<2>>& luminance, std::size_t part) {
    return {luminance.width(), luminance.height(), [&](int x, int y) {
              const double l = static_cast<double>(luminance.at(x, y)[part]);
              return l * l;
            }};
  }
  IntegralImage<double> all_, difference_;
};

/// What turns effective hits per relative solid angle into radiance so that all light is kept.
double radiancePerHit(const Grid<Light<2>>& luminance, const SkyPyramid& sky, const Tally& tally, const Totals& total) {
  const double sum = sumOverRows(sky.height(), [&](int y) {
    double row = 0.0;
    for (int x = 0; x < sky.width(); ++x)
      row += static_cast<double>(luminance.at(x, y)[0]) * static_cast<double>(sky.pixels().omega.at(x, y));
    return row;
  });
  return total.light / (sum * tally.info.interceptedLight() * sky.meanSolidAngle());
}

void develop(Image& image, const Filtered& filtered, const SkyPyramid& sky, const Tally& tally, double scale) {
  const Mat3 toRgb = xyzToRec709(tally.info.white);
  const RelativeVariance variance(filtered.luminance);
  const double hits = hitsPerKernel(1e5);
  forRows(sky.height(), [&](int y) {
    for (int x = 0; x < sky.width(); ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * sky.width() + x;
      const double luminance = scale * static_cast<double>(filtered.luminance[i][0]);
      if (luminance <= 0.0) continue;
      Vec3 rgb(luminance);
      if (filtered.colour.size() > 0) {
        const auto [cy, cx, cz] = filtered.colour[i];
        if (cy > 0.0F)
          rgb = luminance * (toRgb * Vec3(static_cast<double>(cx / cy), 1.0, static_cast<double>(cz / cy)));
      }
      const double sigma =
          std::sqrt(static_cast<double>(kernelVariance(hits, filtered.luminance[i][0] * sky.wholeOmega()[i])));
      const int radius = static_cast<int>(std::clamp(2.0 * sigma, 4.0, 1e5));
      image.channels[0].samples[i] = static_cast<float>(rgb.x);
      image.channels[1].samples[i] = static_cast<float>(rgb.y);
      image.channels[2].samples[i] = static_cast<float>(rgb.z);
      image.channels[3].samples[i] = static_cast<float>(luminance * luminance * variance.at(x, y, radius));
    }
  });
}

template <std::size_t N>
void reconstructInto(Image& image, const Tally& tally, const SkyPyramid& sky, const Totals& total) {
  const Filtered filtered =
      adaptiveFilter<N>(sky, lightIn<N>(tally, sky, total.hitsPerLight()), firstDensity(tally, sky, total));
  develop(image, filtered, sky, tally, radiancePerHit(filtered.luminance, sky, tally, total));
}

}  // namespace

Image adaptiveRadiance(const Tally& tally) {
  Image image{tally.width(), tally.height(), {}};
  for (const char* name : {"R", "G", "B", kVarianceChannel}) image.add(name);

  const std::vector<double> solidAngles = Camera(tally.info.camera).solidAngles();
  const Totals total = totals(tally, solidAngles);
  if (total.hitsPerLight() <= 0.0 || tally.info.interceptedLight() <= 0.0) return image;
  const SkyPyramid sky(tally.width(), tally.height(), solidAngles);
  if (tally.colours() == 1) {
    reconstructInto<2>(image, tally, sky, total);
  } else {
    reconstructInto<4>(image, tally, sky, total);
  }
  return image;
}

}  // namespace parhelion
