// SPDX-License-Identifier: Apache-2.0
#include "cli/halo_source.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "cli/commands.h"
#include "cli/tally_run.h"
#include "parallel/threads.h"
#include "photo/halo_camera.h"
#include "recon/reconstruct.h"
#include "scene/camera_override.h"

namespace parhelion::cli {

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

}  // namespace

void HaloSource::addTo(CLI::App& command) {
  command.add_option("--scene", run.scene, "The scene of the halo; its camera gives way to the photograph's")
      ->type_name("SCENE");
  command.add_option("--halo", picture, "Instead of a scene: a sky that was rendered before, by any camera")
      ->type_name("SKY.exr");
  command
      .add_option("--coarseness", coarseness,
                  "Side of the halo's pixels in the photograph's; a tenth of the sun's disc when left out")
      ->type_name("N")
      ->check(CLI::Range(1, 64));
  run.addTracingTo(command, true);
}

void HaloSource::requireOne() const {
  if (run.scene.empty() && picture.empty()) throw CLI::RequiredError("--scene SCENE, or --halo SKY.exr,");
  if (!run.scene.empty() && !picture.empty()) throw CLI::ValidationError("--scene and --halo exclude each other");
  for (const std::string& override : run.overrides) {
    if (override.starts_with("camera") || override.starts_with("sun.visible"))
      throw CLI::ValidationError("-D " + override,
                                 "the photograph has its own camera and sun; see --fov-horizontal and so on");
  }
  if (run.scene.empty() && (!run.overrides.empty() || !run.rays.empty() || coarseness || !run.stats.empty()))
    throw CLI::ValidationError(
        "-D, --rays, --stats and --coarseness are for a --scene; the sky of --halo is made already");
}

double HaloSource::sunElevation() const {
  return picture.empty() ? run.load().scene.sun.elevation
                         : sceneIn(readExrAttributes(picture), picture).scene.sun.elevation;
}

HaloSource::Result HaloSource::make(const PhotoCamera& camera, const StopSignal& stop) const {
  return picture.empty() ? render(camera, stop) : read(camera);
}

HaloSource::Result HaloSource::render(const PhotoCamera& camera, const StopSignal& stop) const {
  // The photograph has its own sun.
  std::vector<std::string> overrides{sunOverride(camera.sunElevation), "sun.visible=false",
                                     cameraOverride(camera.camera)};
  const LoadedScene whole = run.load(overrides);
  const CameraSettings coarse =
      haloCamera(camera.camera, coarseness.value_or(finestNeeded(camera.camera, whole.scene.sun.diameter)));
  overrides.back() = cameraOverride(coarse);
  const LoadedScene loaded = run.load(overrides);
  const TallyRun traced = traceTally(run, loaded, makeCloud(loaded.scene), stop);
  const ReconstructedSky sky = withThreads(run.threads, [&] { return reconstruct(traced.tally, loaded.scene.recon); });
  return {HaloLookup(sky.image, coarse, camera.camera), sceneAttributes(whole, traced.tally.info.rayCount()),
          traced.result.exitCode()};
}

HaloSource::Result HaloSource::read(const PhotoCamera& camera) const {
  const ExrFile sky = readExr(picture);
  const LoadedScene loaded = sceneIn(sky.attributes, picture);
  if (!sky.image.find("R") || !sky.image.find("G") || !sky.image.find("B"))
    throw std::runtime_error(picture +
                             ": holds hits or channels of its own, no picture; parhelion recon makes one of hits");
  if (sky.attributes.contains(kStrengthKey))
    throw std::runtime_error(picture +
                             ": is made from a photograph; the sky must be one that render or recon has written");
  const double off = std::abs(loaded.scene.sun.elevation - camera.sunElevation);
  constexpr double kMostOff = radians(0.1);  // a fifth of the sun's disc; parhelia move far less
  if (off > kMostOff) {
    char text[200];
    std::snprintf(text, sizeof text, ": its sun is at elevation %.3f degrees, that of the photograph at %.3f",
                  degrees(loaded.scene.sun.elevation), degrees(camera.sunElevation));
    throw std::runtime_error(picture + text);
  }
  ExrAttributes attributes = sky.attributes;
  attributes[kSceneKey] = sceneIn(sky.attributes, picture, {cameraOverride(camera.camera)}).text;
  return {HaloLookup(sky.image, loaded.scene.camera, camera.camera), std::move(attributes), kDone};
}

}  // namespace parhelion::cli
