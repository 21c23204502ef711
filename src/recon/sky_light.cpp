// SPDX-License-Identifier: Apache-2.0
#include "recon/sky_light.h"

#include <algorithm>
#include <cmath>

#include "parallel/loops.h"
#include "picture/colour_space.h"
#include "recon/integral_image.h"
#include "recon/kernel_variance.h"
#include "sky/camera.h"
#include "sky/full_turn.h"
#include "sky/radiance.h"

namespace parhelion {
namespace {

/// Variance of the luminance over its square.
class RelativeVariance {
 public:
  RelativeVariance(int width, int height, const FilteredLight& light)
      : all_(squares(width, height, light.luminance)), difference_(squares(width, height, light.difference)) {}

  double at(int x, int y, int radius) const {
    const double all = all_.square(x, y, radius);
    return all > 0.0 ? difference_.square(x, y, radius) / all : 0.0;
  }

 private:
  template <class F>
  static IntegralImage<double> squares(int width, int height, const F& value) {
    return {width, height, [&](int x, int y) {
              const double v = value(static_cast<std::size_t>(y) * width + x);
              return v * v;
            }};
  }
  IntegralImage<double> all_, difference_;
};

/// Camera::solidAngles() with the rows in parallel.
std::vector<double> solidAnglesOf(const Camera& camera) {
  const int width = camera.width(), height = camera.height();
  const int columns = camera.ownColumns(), rows = camera.ownRows();
  std::vector<double> all(static_cast<std::size_t>(width) * height);
  forRows(rows, [&](int y) {
    double* row = all.data() + static_cast<std::size_t>(y) * width;
    for (int x = 0; x < columns; ++x) row[x] = camera.solidAngle(x, y);
    for (int x = columns; x < width; ++x) row[x] = row[width - 1 - x];
    if (rows < height) std::copy(row, row + width, all.data() + static_cast<std::size_t>(height - 1 - y) * width);
  });
  return all;
}

}  // namespace

SkyLight::SkyLight(const Tally& tally) : tally_(tally), solidAngles_(solidAnglesOf(Camera(tally.info.camera))) {
  const int width = tally.width();
  const Vec3 sums = sumOverRows(tally.height(), [&](int y) {
    Vec3 row(0.0);  // solid angle, luminance, squares
    for (int x = 0; x < width; ++x) {
      const int pixel = y * width + x;
      const double omega = solidAngles_[static_cast<std::size_t>(pixel)];
      if (omega > 0.0) row += Vec3(omega, tally.luminance(pixel), tally.squares(pixel));
    }
    return row;
  });
  const auto pixels = std::count_if(solidAngles_.begin(), solidAngles_.end(), [](double omega) { return omega > 0.0; });
  light_ = sums.y;
  if (pixels > 0) meanSolidAngle_ = sums.x / static_cast<double>(pixels);
  if (sums.z > 0.0 && tally.info.interceptedLight() > 0.0) hitsPerLight_ = light_ / sums.z;
}

SkyLight::Pixel SkyLight::at(std::size_t pixel) const {
  const int p = static_cast<int>(pixel);
  const double all = tally_.luminance(p);
  Pixel light{all * hitsPerLight_, (2.0 * tally_.firstHalf(p) - all) * hitsPerLight_, 0.0, 0.0};
  if (tally_.colours() == 1) return light;
  const Vec3 xyz = tally_.xyz(p);
  light.x = xyz.x * hitsPerLight_;
  light.z = xyz.z * hitsPerLight_;
  return light;
}

HitMap SkyLight::hitMap() const {
  const int width = tally_.width(), height = tally_.height();
  HitMap map;
  map.omega = {width, height};
  map.lights.assign(tally_.colours() == 1 ? 2 : 4, Raster<double>(width, height));
  map.wrapX = isFullTurn(tally_.info.camera);
  forRows(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * width + x;
      if (solidAngles_[i] <= 0.0) continue;
      map.omega[i] = solidAngles_[i] / meanSolidAngle_;
      const Pixel light = at(i);
      map.lights[0][i] = light.luminance;
      map.lights[1][i] = light.difference;
      if (map.lights.size() < 4) continue;
      map.lights[2][i] = light.x;
      map.lights[3][i] = light.z;
    }
  });
  return map;
}

Image SkyLight::develop(const std::vector<Raster<double>>& lights) const {
  const Mat3 toRgb = xyzToRec709(tally_.info.white);
  FilteredLight light;
  light.luminance = [&](std::size_t i) { return lights[0][i]; };
  light.difference = [&](std::size_t i) { return lights[1][i]; };
  light.rgb = [&](std::size_t i) {
    return lights.size() < 4 ? Vec3(lights[0][i]) : toRgb * Vec3(lights[2][i], lights[0][i], lights[3][i]);
  };
  light.hitsPerPixel = [&](std::size_t i) { return lights[0][i] * solidAngles_[i] / meanSolidAngle_; };
  light.hits = hits();
  const double perHit = 1.0 / (hitsPerLight_ * tally_.info.interceptedLight() * meanSolidAngle_);
  return developed(tally_.width(), tally_.height(), light, perHit);
}

Image developed(int width, int height, const FilteredLight& light, double scale) {
  Image image = emptyRadiance(width, height);
  if (light.bias) image.add(kBiasChannel);
  const RelativeVariance variance(width, height, light);
  constexpr double kHitsPerWindow = 90.0;  // under a kernel as wide as the window's standard deviation
  constexpr double kRadius = 2.0;          // of a window, standard deviations of that kernel
  constexpr double kLeastRadius = 4.0;     // pixels
  forRows(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * width + x;
      const double luminance = scale * light.luminance(i);
      const Vec3 rgb = scale * light.rgb(i);
      for (int c = 0; c < 3; ++c) image.channels[static_cast<std::size_t>(c)].samples[i] = static_cast<float>(rgb[c]);
      if (light.bias) image.channels[4].samples[i] = static_cast<float>(scale * light.bias(i));
      if (luminance == 0.0) continue;
      const float hits = static_cast<float>(std::max(light.hitsPerPixel(i), 0.0));
      const double sigma = std::sqrt(static_cast<double>(kernelVariance(kHitsPerWindow, hits)));
      const int radius = static_cast<int>(std::clamp(kRadius * sigma, kLeastRadius, kBeyondAnyPicture));
      const double leastError = light.leastError ? light.leastError(i) : 0.0;
      const double relative = std::max({variance.at(x, y, radius), leastError * leastError, 1.0 / light.hits});
      image.channels[3].samples[i] = static_cast<float>(luminance * luminance * relative);
    }
  });
  return image;
}

Image emptyRadiance(int width, int height) {
  Image image{width, height, {}};
  for (const char* name : {"R", "G", "B", kVarianceChannel}) image.add(name);
  return image;
}

}  // namespace parhelion
