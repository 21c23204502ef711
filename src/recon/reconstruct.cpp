// SPDX-License-Identifier: Apache-2.0
#include "recon/reconstruct.h"

#include "math/overloaded.h"
#include "recon/adaptive/adaptive.h"
#include "recon/published/act.h"
#include "recon/published/gaussian.h"
#include "recon/published/glassner.h"
#include "recon/published/gonzato_marchand.h"
#include "recon/published/marvasti.h"
#include "recon/published/voronoi.h"
#include "recon/sky_light.h"
#include "sky/radiance.h"

namespace parhelion {
namespace {

/// What the named methods have in common: they know nothing but pixels.
template <class Method, class Settings>
ReconstructedSky byMethod(const Tally& tally, const Settings& settings, const Watch& watch, const Method& method) {
  const SkyLight light(tally);
  if (light.hitsPerLight() <= 0.0) return {emptyRadiance(tally.width(), tally.height()), {}};
  Reconstruction result = method(light.hitMap(), settings, watch);
  return {light.develop(result.lights), std::move(result.remarks)};
}

bool isDark(const Tally& tally) {
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) {
    if (tally.raw(pixel, Tally::kY) != 0) return false;
  }
  return true;
}

}  // namespace

ReconstructedSky reconstruct(const Tally& tally, const ReconSettings& settings, const Watch& watch) {
  ReconstructedSky sky =
      std::visit(Overloaded{
                     [&](const AdaptiveSettings&) {
                       return ReconstructedSky{adaptiveRadiance(tally, watch), {}};
                     },
                     [&](const NoSettings&) {
                       return ReconstructedSky{plainRadiance(tally), {}};
                     },
                     [&](const GaussianSettings& own) { return byMethod(tally, own, watch, gaussian); },
                     [&](const GlassnerSettings& own) { return byMethod(tally, own, watch, glassner); },
                     [&](const MarvastiSettings& own) { return byMethod(tally, own, watch, marvasti); },
                     [&](const VoronoiSettings& own) { return byMethod(tally, own, watch, voronoi); },
                     [&](const ActSettings& own) { return byMethod(tally, own, watch, act); },
                     [&](const GonzatoMarchandSettings& own) { return byMethod(tally, own, watch, gonzatoMarchand); },
                 },
                 settings);
  if (isDark(tally)) sky.remarks.emplace_back("no light in the sky: the picture is black");
  watch.at(1.0);
  return sky;
}

}  // namespace parhelion
