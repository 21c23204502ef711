// SPDX-License-Identifier: Apache-2.0
#include "recon/reconstruct.h"

#include "recon/methods.h"
#include "recon/sky_light.h"
#include "sky/radiance.h"

namespace parhelion {
namespace {

/// By a method that is given the tally.
template <class Settings>
auto byMethod(const Tally& tally, const Settings& settings, const Watch& watch)
    -> decltype(reconstructSky(tally, settings, watch)) {
  return reconstructSky(tally, settings, watch);
}

/// By a method that knows nothing but pixels.
template <class Settings>
auto byMethod(const Tally& tally, const Settings& settings, const Watch& watch)
    -> decltype(reconstructHits(HitMap(), settings, watch), ReconstructedSky()) {
  const SkyLight light(tally);
  if (light.hitsPerLight() <= 0.0) return {emptyRadiance(tally.width(), tally.height()), {}};
  Reconstruction result = reconstructHits(light.hitMap(), settings, watch);
  return {light.develop(result.lights), std::move(result.remarks)};
}

bool isDark(const Tally& tally) {
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) {
    if (tally.raw(pixel, Tally::kY) != 0) return false;
  }
  return true;
}

}  // namespace

ReconstructedSky reconstructSky(const Tally& tally, const NoSettings&, const Watch&) {
  return {plainRadiance(tally), {}};
}

ReconstructedSky reconstruct(const Tally& tally, const ReconSettings& settings, const Watch& watch) {
  ReconstructedSky sky = std::visit([&](const auto& own) { return byMethod(tally, own, watch); }, settings);
  if (isDark(tally)) sky.remarks.emplace_back("no light in the sky: the picture is black");
  watch.at(1.0);
  return sky;
}

}  // namespace parhelion
