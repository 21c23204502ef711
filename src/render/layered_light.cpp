// SPDX-License-Identifier: Apache-2.0
#include "render/layered_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "optics/spectrum.h"
#include "optics/sun.h"
#include "parallel/loops.h"
#include "picture/colour_space.h"
#include "sky/radiance.h"
#include "sky/sky_tally.h"

namespace parhelion {

namespace {

/// The channels of some light; null where a picture has none of it.
using ColourPlanes = std::array<std::vector<float>*, 3>;

ColourPlanes planesOf(Image& image, const std::string& before) {
  return {image.find(before + "R"), image.find(before + "G"), image.find(before + "B")};
}

double luminanceOf(const Vec3& colour) {
  return kRec709Luminance.x * colour.x + kRec709Luminance.y * colour.y + kRec709Luminance.z * colour.z;
}

double depthOf(const SlabStack::Layer& layer, const Vec3& direction) {
  return layer.extinction.at(direction).depth(layer.opticalDepth) / std::max(std::abs(direction.z), kLevelRise);
}

}  // namespace

LayeredLight::LayeredLight(const SlabStack& stack, const Extinction& all, const Scene& scene)
    : illuminance_(solarIlluminance(scene.sun.spectrum)),
      toSun_(Sun(scene.sun).toCentre()),
      sides_(crystalSides(scene)) {
  const Extinction::Crystals lit = all.at(toSun_);
  shadow_ = lit.shadow * (1.0 - lit.ofHaze) * all.zenithShadow();
  double above = 0.0;
  for (const SlabStack::Layer& layer : stack.layers()) {
    const double own = depthOf(layer, toSun_);
    layers_.push_back({&layer, layer.opticalDepth / layer.extinction.zenithShadow(), own, above, {}});
    above += own;
  }
  for (const PopulationSettings& population : scene.populations) populations_.push_back(population.name);
  for (std::size_t h = 0; h < scene.hazes.size(); ++h) {
    phases_.emplace_back(scene.hazes[h].phase);
    hazes_.push_back(all.hazeShadow(h));
  }
  if (!all.isSameAllAround()) return;
  std::vector<ByElevation> tables;
  for (std::size_t k = 0; k < layers_.size(); ++k)
    tables.emplace_back([&](const Vec3& toSky) { return lightOf(k, toSky); });
  for (std::size_t k = 0; k < layers_.size(); ++k) layers_[k].light = std::move(tables[k]);
}

double LayeredLight::fromSun() const { return layers_.back().fromSunTop + layers_.back().fromSun; }

/// Luminance of what the layer sends there, of crystals that intercept a unit of light for each unit of surface and
/// send it evenly to all sides, times 4 pi.
double LayeredLight::lightOf(std::size_t k, const Vec3& toSky) const {
  if (!(toSun_.z > 0.0) || !sides_.has(toSky)) return 0.0;
  const Layer& layer = layers_[k];
  const bool seenFromBelow = toSky.z > 0.0;
  const double own = depthOf(*layer.contents, toSky);
  double between = layer.fromSunTop;
  for (std::size_t other = 0; other < layers_.size(); ++other)
    if (seenFromBelow ? other > k : other < k) between += depthOf(*layers_[other].contents, toSky);
  const double through = seenFromBelow
                             ? portable::exp(-std::min(layer.fromSun, own)) * meanThrough(std::abs(own - layer.fromSun))
                             : meanThrough(layer.fromSun + own);
  return illuminance_ * layer.depth * portable::exp(-between) * through / std::max(std::abs(toSky.z), kLevelRise);
}

double LayeredLight::at(std::size_t layer, const Vec3& toSky) const {
  return layers_[layer].light.isEmpty() ? lightOf(layer, toSky) : layers_[layer].light.at(toSky);
}

double LayeredLight::hazeAt(const Vec3& toSky) const {
  const double cosine = toSky.x * toSun_.x + toSky.y * toSun_.y + toSky.z * toSun_.z;
  double sum = 0.0;
  for (std::size_t k = 0; k < layers_.size(); ++k) {
    double own = 0.0;
    for (const std::size_t haze : layers_[k].contents->hazes) own += hazes_[haze] * phases_[haze].at(cosine);
    if (own > 0.0) sum += own * at(k, toSky);
  }
  return sum;
}

void LayeredLight::apply(Image& image, const Camera& camera) const {
  const ColourPlanes whole = planesOf(image, ""), rest = planesOf(image, std::string(kRestLayer) + ".");
  std::vector<ColourPlanes> own;
  for (const std::string& name : populations_) own.push_back(planesOf(image, name + "."));
  const auto isThere = [](const ColourPlanes& planes) { return planes[0] && planes[1] && planes[2]; };
  if (!isThere(whole) || std::ranges::none_of(own, isThere))
    throw std::runtime_error("the picture does not tell the light of the cloud's populations apart");
  std::vector<float>*variance = image.find(kVarianceChannel), *bias = image.find(kBiasChannel);
  forRows(image.height, [&](int y) {
    for (int x = 0; x < image.width; ++x) {
      const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x);
      Vec3 before(0.0), after(0.0);
      double most = 0.0;
      for (std::size_t p = 0; p < own.size(); ++p) {
        if (!isThere(own[p])) continue;
        double factor = 0.0;
        for (std::size_t k = 0; k < layers_.size(); ++k)
          if (std::ranges::find(layers_[k].contents->populations, p) != layers_[k].contents->populations.end())
            factor += shadow_ * meanOverSlabPixel(camera, x, y, [&](const Vec3& toSky) { return at(k, toSky); });
        most = std::max(most, factor);
        for (std::size_t c = 0; c < 3; ++c) {
          const double light = static_cast<double>((*own[p][c])[i]);
          before[static_cast<int>(c)] += light;
          after[static_cast<int>(c)] += factor * light;
          (*own[p][c])[i] = static_cast<float>(factor * light);
        }
      }
      const double single = luminanceOf(before), clouded = luminanceOf(after);
      const double ratio = single > 0.0 && clouded > 0.0 ? clouded / single : most;
      if (variance) (*variance)[i] = static_cast<float>(ratio * ratio * static_cast<double>((*variance)[i]));
      if (bias) (*bias)[i] = static_cast<float>(ratio * static_cast<double>((*bias)[i]));
      const double haze =
          phases_.empty() ? 0.0 : meanOverSlabPixel(camera, x, y, [&](const Vec3& toSky) { return hazeAt(toSky); });
      for (std::size_t c = 0; c < 3; ++c) {
        (*whole[c])[i] = static_cast<float>(after[static_cast<int>(c)] + haze);
        if (rest[c]) (*rest[c])[i] = static_cast<float>(haze);
      }
    }
  });
}

}  // namespace parhelion
