// SPDX-License-Identifier: Apache-2.0
#include "cli/halo_options.h"

#include <utility>

#include "cli/commands.h"
#include "cli/file_words.h"
#include "cli/number_options.h"
#include "cli/trace_watch.h"
#include "render/needs.h"

namespace parhelion::cli {

void HaloOptions::addTo(CLI::App& command) {
  command.add_option("--scene", run.scene, "The scene of the halo; its camera gives way to the photograph's")
      ->type_name("SCENE");
  command.add_option("--halo", picture, "Instead of a scene: a sky that was rendered before, by any camera")
      ->type_name("SKY.exr");
  command
      .add_option("--coarseness", coarseness,
                  "Side of the halo's pixels in the photograph's; a tenth of the sun's disc when left out")
      ->type_name("N")
      ->transform(wholeNumber(1, 64));
  run.addTracingTo(command, true);
}

void HaloOptions::requireOne() const {
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

double HaloOptions::sunElevation() const {
  if (!picture.empty()) requireFit(picture, Wanted::sky);
  return picture.empty() ? run.load().scene.sun.elevation : sunElevationIn(picture);
}

std::uint64_t HaloOptions::memoryFor(const PhotoCamera& camera) const {
  if (!picture.empty()) return 0;
  const Scene scene = sceneFor(camera).coarse.scene;
  return memoryToRender(skySizeOf(scene), scene.recon, run.threads);
}

MadeHalo HaloOptions::make(const PhotoCamera& camera, EditedPictures edited) const {
  return picture.empty() ? render(camera) : MadeHalo{readHalo(picture, camera, edited), {}};
}

HaloScene HaloOptions::sceneFor(const PhotoCamera& camera) const {
  const SceneLoader load = [this](const std::vector<std::string>& overrides) { return run.load(overrides); };
  return haloSceneFor(camera, coarseness, load);
}

MadeHalo HaloOptions::render(const PhotoCamera& camera) const {
  const HaloScene scene = sceneFor(camera);
  TraceWatch watch(run, scene.coarse.scene.trace.rays);
  const TracedSky traced = traceSky(scene.coarse, cloudOf(scene.coarse.scene), watch.control());
  RunFigures figures = watch.report(traced.report, traced.settings);
  return {haloOf(traced, scene, camera, run.threads), std::move(figures)};
}

}  // namespace parhelion::cli
