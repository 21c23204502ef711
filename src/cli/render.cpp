// SPDX-License-Identifier: Apache-2.0
#include "cli/commands.h"
#include "cli/picture.h"
#include "cli/run_options.h"
#include "cli/tally_run.h"
#include "cli/text_output.h"
#include "parallel/threads.h"

namespace parhelion::cli {

namespace {

struct RenderOptions {
  RunOptions run;
  PictureOptions picture;
};

int runRender(const RenderOptions& options) {
  const LoadedScene loaded = options.run.load();
  const std::string& scene = options.run.scene;
  requireOutputs(scene, {options.picture.exr(scene), options.picture.png(scene), options.run.stats});
  // Also while the picture is made, so that a late Ctrl-C does not lose what was traced.
  const StopSignal stop;
  const TallyRun run = traceTally(options.run, loaded, makeCloud(loaded.scene), stop);
  ReconstructedSky sky = withThreads(options.run.threads, [&] { return reconstruct(run.tally, loaded.scene.recon); });
  writePicture(std::move(sky), run.tally.info, loaded, options.picture, scene, options.run.quiet);
  return run.result.exitCode();
}

}  // namespace

void addRender(CLI::App& app, int& exit) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "Render a scene to a linear EXR and a PNG preview beside it");
  options->run.addTo(*command, true);
  options->picture.addTo(*command);
  command->callback([options, &exit] { exit = runRender(*options); });
}

}  // namespace parhelion::cli
