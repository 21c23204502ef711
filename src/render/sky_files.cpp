// SPDX-License-Identifier: Apache-2.0
#include "render/sky_files.h"

#include <cstdio>
#include <map>

#include "air/air_sky.h"
#include "parallel/threads.h"
#include "picture/auto_exposure.h"
#include "picture/png.h"
#include "render/air_background.h"
#include "render/scene_attributes.h"
#include "render/slab_light.h"
#include "sky/camera.h"
#include "sky/draw_sun.h"
#include "sky/envmap.h"
#include "sky/radiance.h"

namespace parhelion {

ReconstructedSky developSky(const TracedSky& traced, const LoadedScene& loaded, int threads) {
  return withThreads(threads, [&] { return reconstruct(traced.tally, loaded.scene.recon); });
}

std::optional<OrderReport> writeSky(const Output& exr, Image& image, const TallyInfo& info, const LoadedScene& loaded,
                                    Gamut gamut, const SkyAdditions& additions) {
  const Camera camera(info.camera);
  const Scene& scene = loaded.scene;
  const bool air = scene.sky.air;
  std::optional<SlabLight> slab;
  std::optional<MoreOrders> more;
  if (isAbsolute(scene) || !scene.hazes.empty())
    slab = withThreads(additions.threads, [&] { return SlabLight(scene, info.undeviatedFraction()); });
  if (isAbsolute(scene))
    more = moreOrders(loaded, info.rayCount(), *slab, additions.gains, additions.threads, additions.watch);
  if (air) {
    addAir(image, camera, info, scene, additions.threads, *slab, more ? &more->image : nullptr);
  } else if (slab) {
    addHaze(image, camera, scene, slab->ofHaze());
    if (scene.cloud) slab->apply(image, camera);
    if (more) addPart(more->image, 1.0, {}, image);
    if (!scene.cloud) slab.reset();
  }
  if (!air && loaded.scene.sun.visible)
    drawUndeviatedSun(image, camera, Sun(loaded.scene.sun),
                      slab ? slab->directIlluminance() : info.undeviatedFraction());
  ExrAttributes attributes = sceneAttributes(loaded, info.rayCount());
  if (slab || air) attributes[kWhiteLuminanceKey] = "1";
  if (gamut == Gamut::clip) image.changeColours(intoGamut);
  if (gamut != Gamut::exact) attributes[kGamutKey] = nameOf(gamut);
  const Envmap envmap = envmapOf(camera);
  // Blender takes a channel with a dot in its name for the sign of several layers, which it lights nothing with.
  if (envmap == Envmap::latLong)
    std::erase_if(image.channels, [](const Channel& channel) { return channel.name.find('.') != std::string::npos; });
  writeBeautyExr(exr, image, attributes, envmap,
                 gamut == Gamut::acescg ? kAcesCgChromaticities : kRec709Chromaticities);
  return more ? std::optional(more->report) : std::nullopt;
}

bool isAbsolute(const Scene& scene) { return scene.cloud.has_value() || scene.sky.air; }

std::string whyUnlit(const Scene& scene) {
  constexpr double kGreen = 550.0, kMetresPerKilometre = 1000.0;  // nm; air hides the sun at all wavelengths alike
  if (scene.cloud && !(scene.sun.elevation > 0.0))
    return "a cloud without an end takes all light of a sun that is not above the horizon";
  const double altitude = scene.observer.altitude / kMetresPerKilometre + kEyeHeight;
  if (scene.sky.air && !(Atmosphere(scene.sky).sunTransmittance(kGreen, altitude, scene.sun.elevation) > 0.0))
    return "the sun is below the horizon";
  return {};
}

double ownExposure(const Image& image, const Scene& scene) {
  return scene.sky.air ? exposureOfScenery(image) : autoExposure(image);
}

ToneSettings previewTone(LightDisplay how, const Image& image, const Scene& scene) {
  if (!how.exposure && !how.exposureValue) how.exposure = ownExposure(image, scene);
  return toneFor(how, image, isAbsolute(scene) ? std::optional(1.0) : std::nullopt);
}

std::string exposureText(double stops) {
  char text[64];
  std::snprintf(text, sizeof text, "%+.2f stops", stops);
  return text;
}

void writePreview(const Output& png, const Preview& preview, double stops, const std::string& scene) {
  std::map<std::string, std::string> text{{"Software", kSoftware}, {"Exposure", exposureText(stops)}};
  if (!scene.empty()) text[kSceneKey] = scene;
  writePng(png, preview, text);
}

WrittenSky writeSkyFiles(const SkyFiles& files, Image image, const TallyInfo& info, const LoadedScene& loaded) {
  const auto orders =
      writeSky({files.exr, files.run}, image, info, loaded, files.gamut, {files.gains, files.threads, files.watch});
  const ToneSettings tone = previewTone(files.display, image, loaded.scene);
  const Preview preview = developPreview(image, tone);
  writePreview({files.png, files.run}, preview, tone.exposureStops, loaded.text);
  return {tone.exposureStops, preview.badPixels, orders, whyUnlit(loaded.scene)};
}

}  // namespace parhelion
