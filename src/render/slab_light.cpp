// SPDX-License-Identifier: Apache-2.0
#include "render/slab_light.h"

#include <algorithm>
#include <cmath>

#include "math/portable.h"
#include "optics/spectrum.h"
#include "optics/sun.h"
#include "parallel/loops.h"
#include "render/layered_light.h"
#include "sky/radiance.h"

namespace parhelion {

namespace {

// Vertical optical depth of crystals of which a scene does not say how many there are.
constexpr double kThinDepth = 0.05;
}  // namespace

SlabLight::SlabLight(const Scene& scene, double undeviated)
    : extinction_(scene.sun, scene.ice, scene.populations, scene.hazes),
      stack_(extinction_, scene.populations, scene.hazes, scene.cloud ? *scene.cloud : SlabSettings{kThinDepth, 1, {}}),
      illuminance_(solarIlluminance(scene.sun.spectrum)),
      toSun_(Sun(scene.sun).toCentre()),
      sunShadow_(extinction_.at(toSun_).shadow),
      ofHaze_(extinction_.at(toSun_).ofHaze),
      isLit_(!scene.cloud || toSun_.z > 0.0),
      sides_(crystalSides(scene)),
      fromSun_(scene.cloud ? stack_.layers().front().opticalDepth * (1.0 - undeviated * (1.0 - ofHaze_)) * sunShadow_ /
                                 std::max(toSun_.z, kLevelRise)
                           : 0.0) {
  if (scene.cloud && !scene.cloud->layers.empty()) {
    layered_ = std::make_unique<LayeredLight>(stack_, extinction_, scene);
    fromSun_ = layered_->fromSun();
    ofHaze_ = 0.0;
    return;
  }
  if (extinction_.isSameAllAround())
    byElevation_ = ByElevation([this](const Vec3& toSky) { return exactLuminanceAt(toSky); });
}

SlabLight::SlabLight(SlabLight&&) noexcept = default;
SlabLight& SlabLight::operator=(SlabLight&&) noexcept = default;
SlabLight::~SlabLight() = default;

double SlabLight::directIlluminance() const { return isLit_ ? illuminance_ * portable::exp(-fromSun_) : 0.0; }

double SlabLight::luminanceAt(const Vec3& toSky) const {
  return byElevation_.isEmpty() ? exactLuminanceAt(toSky) : byElevation_.at(toSky);
}

double SlabLight::exactLuminanceAt(const Vec3& toSky) const {
  if (!isLit_ || !sides_.has(toSky)) return 0.0;
  const double opticalDepth = stack_.layers().front().opticalDepth;
  const double rise = std::max(std::abs(toSky.z), kLevelRise);
  const double toObserver = extinction_.at(toSky).depth(opticalDepth) / rise;
  const double through =
      toSky.z > 0.0 ? portable::exp(-std::min(fromSun_, toObserver)) * meanThrough(std::abs(toObserver - fromSun_))
                    : meanThrough(fromSun_ + toObserver);
  return illuminance_ * opticalDepth * sunShadow_ * through / rise;
}

void SlabLight::apply(Image& image, const Camera& camera) const {
  if (layered_) return layered_->apply(image, camera);
  forRows(image.height, [&](int y) {
    for (int x = 0; x < image.width; ++x) {
      const double luminance = meanOverSlabPixel(camera, x, y, [&](const Vec3& toSky) { return luminanceAt(toSky); });
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
