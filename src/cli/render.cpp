// SPDX-License-Identifier: Apache-2.0
#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/picture.h"
#include "cli/run_options.h"
#include "cli/trace_watch.h"
#include "parallel/threads.h"
#include "picture/memory_limit.h"
#include "render/needs.h"
#include "render/sky_files.h"

namespace parhelion::cli {

namespace {

struct RenderOptions {
  RunOptions run;
  PictureOptions picture;
};

int runRender(const RenderOptions& options) {
  const LoadedScene loaded = options.run.load();
  const std::string& scene = options.run.scene;
  SkyFiles files = options.picture.files(scene);
  const SkySize size = skySizeOf(loaded.scene);
  requireMemory("the picture", memoryToReconstruct(size, loaded.scene.recon, options.run.threads));
  Transaction outputs = claimOutputs({{scene},
                                      {files.exr, files.png, options.run.stats},
                                      {},
                                      {{files.exr, leastBytesOfPicture(size, loaded.scene.recon)}}},
                                     options.run.overwrite);
  // Also while the picture is made, so that a late Ctrl-C does not lose what was traced.
  const StopSignal stop;
  TraceWatch watch(options.run, loaded.scene.trace.rays, &stop);
  const TracedSky traced = traceSky(loaded, cloudOf(loaded.scene), watch.control());
  const int exit = watch.report(traced, outputs);
  ReconstructedSky sky = developSky(traced, loaded, options.run.threads);
  files.run = &outputs;
  const WrittenSky written = writeSkyFiles(files, std::move(sky.image), traced.tally.info, loaded);
  outputs.commit();
  if (!options.run.quiet) reportPicture(files, written, sky.remarks);
  return exit;
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
