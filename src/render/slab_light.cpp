// SPDX-License-Identifier: Apache-2.0
#include "render/slab_light.h"

#include <algorithm>
#include <cmath>

#include "math/arctangent.h"
#include "math/portable.h"
#include "math/rotation.h"
#include "optics/spectrum.h"
#include "optics/sun.h"
#include "parallel/loops.h"
#include "sky/pixel_mean.h"
#include "sky/radiance.h"

namespace parhelion {

namespace {

// Vertical optical depth of crystals of which a scene does not say how many there are.
constexpr double kThinDepth = 0.05;
// Light along the horizon has gone through a cloud without end: the sine of the elevation is never taken for less.
constexpr double kLevel = 1e-6;
// Of elevations, where azimuths do not matter: closer toward the horizon.
constexpr std::size_t kNodes = 4096;
// Pixels within this of the horizon (rad), or so many times the size that pixels have on the axis, are looked at by so
// many points to a side.
constexpr double kNearHorizon = 0.02, kWide = 4.0;
constexpr int kPoints = 8;

/// (1 - exp(-x)) / x for x >= 0.
double meanThrough(double x) { return x < 1e-5 ? 1.0 - 0.5 * x : (1.0 - portable::exp(-x)) / x; }

}  // namespace

SlabLight::SlabLight(const Scene& scene, double undeviated)
    : extinction_(scene.sun, scene.ice, scene.populations, scene.hazes),
      opticalDepth_(scene.cloud ? scene.cloud->opticalDepth : kThinDepth),
      illuminance_(solarIlluminance(scene.sun.spectrum)),
      toSun_(Sun(scene.sun).toCentre()),
      sunShadow_(extinction_.at(toSun_).shadow),
      ofHaze_(extinction_.at(toSun_).ofHaze),
      isLit_(!scene.cloud || toSun_.z > 0.0),
      fromSun_(scene.cloud
                   ? opticalDepth_ * (1.0 - undeviated * (1.0 - ofHaze_)) * sunShadow_ / std::max(toSun_.z, kLevel)
                   : 0.0) {
  if (extinction_.isSameAllAround()) tabulate();
}

double SlabLight::directIlluminance() const { return isLit_ ? illuminance_ * portable::exp(-fromSun_) : 0.0; }

double SlabLight::luminanceAt(const Vec3& toSky) const {
  if (byElevation_.empty()) return exactLuminanceAt(toSky);
  const double place =
      kNodes * std::sqrt(std::abs(arctangent(toSky.z, std::sqrt(toSky.x * toSky.x + toSky.y * toSky.y))) / (0.5 * kPi));
  const auto node = std::min(static_cast<std::size_t>(place), kNodes - 1);
  const double* const at = &byElevation_[(toSky.z > 0.0 ? 0 : kNodes + 1) + node];
  return at[0] + (place - static_cast<double>(node)) * (at[1] - at[0]);
}

void SlabLight::tabulate() {
  std::vector<double> all;
  for (const double side : {1.0, -1.0})
    for (std::size_t k = 0; k <= kNodes; ++k) {
      const double place = static_cast<double>(k) / static_cast<double>(kNodes), elevation = 0.5 * kPi * place * place;
      all.push_back(exactLuminanceAt(skyDirection(0.0, side * std::max(elevation, kLevel))));
    }
  byElevation_ = std::move(all);
}

double SlabLight::exactLuminanceAt(const Vec3& toSky) const {
  if (!isLit_) return 0.0;
  const double rise = std::max(std::abs(toSky.z), kLevel);
  const Extinction::Crystals between = extinction_.at(toSky);
  const double toObserver = opticalDepth_ * (1.0 - between.undeviated) * between.shadow / rise;
  const double through =
      toSky.z > 0.0 ? portable::exp(-std::min(fromSun_, toObserver)) * meanThrough(std::abs(toObserver - fromSun_))
                    : meanThrough(fromSun_ + toObserver);
  return illuminance_ * opticalDepth_ * sunShadow_ * through / rise;
}

double SlabLight::meanOver(const Camera& camera, int x, int y) const {
  const auto middle = camera.toSky({x + 0.5, y + 0.5});
  if (middle && std::abs(middle->z) > std::max(kNearHorizon, kWide / camera.focalLength())) return luminanceAt(*middle);
  return meanOverPixel(camera, x, y, kPoints, [&](const Vec3& toSky) { return luminanceAt(toSky); });
}

void SlabLight::apply(Image& image, const Camera& camera) const {
  forRows(image.height, [&](int y) {
    for (int x = 0; x < image.width; ++x) {
      const double luminance = meanOver(camera, x, y);
      const std::size_t pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
      for (Channel& channel : image.channels) {
        const double factor = channel.name == kVarianceChannel ? luminance * luminance : luminance;
        channel.samples[pixel] = static_cast<float>(factor * static_cast<double>(channel.samples[pixel]));
      }
    }
  });
}

}  // namespace parhelion
