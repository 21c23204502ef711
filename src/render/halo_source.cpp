// SPDX-License-Identifier: Apache-2.0
#include "render/halo_source.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "photo/halo_camera.h"
#include "render/sky_files.h"
#include "scene/camera_override.h"

namespace parhelion {

namespace {

std::string sunOverride(double elevation) {
  char text[64];
  std::snprintf(text, sizeof text, "sun.elevation=%.12g", degrees(elevation));
  return text;
}

LoadedScene sceneIn(const ExrAttributes& attributes, const std::string& path,
                    const std::vector<std::string>& overrides = {}) {
  const auto scene = attributes.find(kSceneKey);
  if (scene == attributes.end())
    throw std::runtime_error(path + ": is no sky rendered by parhelion: it carries no scene that tells its camera");
  return parseScene(scene->second, path, overrides);
}

/// Throws unless a file is the picture of a sky.
void requireSky(const ExrFile& sky, const std::string& path) {
  if (!sky.image.find("R") || !sky.image.find("G") || !sky.image.find("B"))
    throw std::runtime_error(path +
                             ": holds hits or channels of its own, no picture; parhelion recon makes one of hits");
  if (sky.attributes.contains(kStrengthKey))
    throw std::runtime_error(path +
                             ": is made from a photograph; the sky must be one that render or recon has written");
}

void requireSameSun(double ofSky, double ofPhotograph, const std::string& path) {
  constexpr double kMostOff = radians(0.1);  // a fifth of the sun's disc; parhelia move far less
  if (!(std::abs(ofSky - ofPhotograph) > kMostOff)) return;
  char text[200];
  std::snprintf(text, sizeof text, ": its sun is at elevation %.3f degrees, that of the photograph at %.3f",
                degrees(ofSky), degrees(ofPhotograph));
  throw std::runtime_error(path + text);
}

}  // namespace

HaloScene haloSceneFor(const PhotoCamera& camera, std::optional<int> coarseness, const SceneLoader& load) {
  // The photograph has its own sun.
  std::vector<std::string> overrides{sunOverride(camera.sunElevation), "sun.visible=false",
                                     cameraOverride(camera.camera)};
  LoadedScene whole = load(overrides);
  if (whole.scene.sky.air) {
    // ... and its own air.
    overrides.insert(overrides.begin(), "sky.air=false");
    whole = load(overrides);
  }
  const CameraSettings coarse =
      haloCamera(camera.camera, coarseness.value_or(finestNeeded(camera.camera, whole.scene.sun.diameter)));
  overrides.back() = cameraOverride(coarse);
  return {std::move(whole), load(overrides), coarse};
}

PhotoHalo haloOf(const TracedSky& traced, const HaloScene& scene, const PhotoCamera& camera, int threads) {
  const ReconstructedSky sky = developSky(traced, scene.coarse, threads);
  return {HaloLookup(sky.image, scene.camera, camera.camera),
          sceneAttributes(scene.whole, traced.tally.info().rayCount())};
}

double sunElevationIn(const std::filesystem::path& sky) {
  return sceneIn(readExrAttributes(sky), sky.string()).scene.sun.elevation;
}

PhotoHalo readHalo(const std::filesystem::path& path, const PhotoCamera& camera, EditedPictures edited) {
  constexpr int kOfLookup = 32;  // bytes a pixel
  const ExrFile sky = readExr(path, ExrColours::rec709, {true, kOfLookup, edited});
  const LoadedScene loaded = sceneIn(sky.attributes, path.string());
  if (loaded.scene.sky.air)
    throw std::runtime_error(path.string() +
                             ": shows the air, too; a photograph has its own: render the halo with -D sky.air=false");
  requireSky(sky, path.string());
  requireSameSun(loaded.scene.sun.elevation, camera.sunElevation, path.string());
  ExrAttributes attributes = sky.attributes;
  attributes.erase(kWhiteLuminanceKey);  // of the sky's light, not of the photograph's
  attributes[kSceneKey] = sceneIn(sky.attributes, path.string(), {cameraOverride(camera.camera)}).text;
  return {HaloLookup(sky.image, loaded.scene.camera, camera.camera), std::move(attributes)};
}

}  // namespace parhelion
