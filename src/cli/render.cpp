// SPDX-License-Identifier: Apache-2.0
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/integral_run.h"
#include "cli/long_run.h"
#include "cli/outputs.h"
#include "cli/picture.h"
#include "cli/say.h"
#include "cli/stats.h"
#include "cli/trace_watch.h"
#include "parallel/run_clock.h"
#include "parallel/threads.h"
#include "picture/memory_limit.h"
#include "render/development.h"
#include "render/engine_choice.h"
#include "render/integrated_sky.h"
#include "render/mixed_sky.h"
#include "render/needs.h"
#include "render/sky_files.h"
#include "render/sky_sums.h"
#include "render/table_cache.h"

namespace parhelion::cli {

namespace {

struct RenderOptions {
  RunOptions run;
  LongRunOptions longRun;
  PictureOptions picture;
};

/// Where a picture's tally goes; empty for a picture that goes nowhere.
std::filesystem::path tallyOf(const SkyFiles& files) {
  if (isStream(files.exr)) return {};
  std::filesystem::path tally = files.exr;
  return tally.replace_extension(".tally.exr");
}

/// Renders without rays, or with rays for some populations alone. None where a choice takes rays for all instead.
std::optional<int> renderSmooth(const RenderOptions& options, const CLI::App& command, LoadedScene loaded,
                                EngineChoice* choice) {
  const bool mixed = loaded.scene.trace.engine == Engine::mixed;
  refuseRayOptions(command, mixed ? RayOptions::someRays : RayOptions::none);
  requireIntegrable(loaded.scene);
  const std::string& scene = options.run.scene;
  SkyFiles files = options.picture.files(scene);
  requireUnit(files.display, loaded.scene);
  const SkySize size = skySizeOf(loaded.scene);
  const double goal = integralGoal(options.longRun.error);
  const std::uint64_t integrating = memoryToIntegrate(size) + memoryOfOrientations(loaded.scene, goal);
  requireMemory("the picture",
                mixed ? integrating + memoryToRender(size, loaded.scene.recon, options.run.threads) : integrating);
  Transaction outputs = claimOutputs({{scene},
                                      {files.exr, files.png, options.run.stats},
                                      {},
                                      {{files.exr, leastBytesOfPicture(size, loaded.scene.recon)}}},
                                     options.run.overwrite);
  loaded.error = goal;
  const RunClock clock;
  const StopSignal stop;
  LightStore store{BandStore(), ringStoreWith(tableCacheOfUser())};
  MixGoal until{goal, !options.longRun.error.empty(), {}};
  if (choice) until.goOn = [&](double work) { return choice->goOn(work); };
  MixedSky made = mixSky(loaded, until, traceControl(options.run, &stop), &store);
  if (made.sky.refused) return {};
  if (made.report.interrupted) return kInterrupted;
  IntegratedSky& sky = made.sky;
  const double seconds = clock.seconds();
  if (!options.run.quiet) reportSmooth(made);
  if (!sky.reached) say("warning: the error asked for was not reached; the picture has its errors as they are");
  files.run = &outputs;
  files.threads = options.run.threads;
  files.watch = walkWatch(options.run, &stop);
  const WrittenSky written = writeSkyFiles(files, std::move(sky.image), sky.info, loaded);
  files.watch = {};
  if (!options.run.stats.empty()) {
    const Engine engine = loaded.scene.trace.engine;
    nlohmann::ordered_json json = smoothStats(made, seconds, options.run.threads, engine);
    if (choice) json["choice"] = choiceStats(*choice);
    if (written.orders) json["orders"] = ordersJson(*written.orders);
    writeJson(outputs.at(options.run.stats), json);
  }
  outputs.commit();
  if (!options.run.quiet) reportPicture(files, written, {});
  return written.orders && written.orders->interrupted ? kInterrupted : kDone;
}

int runRender(const RenderOptions& options, const CLI::App& command, Tracers& tracers) {
  LoadedScene loaded = options.run.load();
  std::optional<EngineChoice> choice;
  TraceControl looks = traceControl(options.run, nullptr);
  looks.onProgress = {};
  if (isIntegrated(loaded.scene)) return *renderSmooth(options, command, std::move(loaded), nullptr);
  if (asksForErrorAlone(command) && tracers.processes() == 1) {
    LoadedScene smooth = loaded;
    smooth.scene.trace.engine = integratingEngine(loaded.scene);
    if (isIntegrated(smooth.scene)) {
      choice.emplace(loaded, options.longRun.goal(), looks);
      if (const auto exit = renderSmooth(options, command, std::move(smooth), &*choice)) return *exit;
      if (!options.run.quiet) reportChoice(*choice);
    }
  }
  const std::string& scene = options.run.scene;
  SkyFiles files = options.picture.files(scene);
  requireUnit(files.display, loaded.scene);
  const Cloud cloud = cloudOf(loaded.scene);
  const TraceSettings settings = chosenSettings(cloud, loaded.scene.trace);
  const RayRange wanted = options.longRun.wanted(settings.rays, cloud.bundleSize(), options.run);
  const std::filesystem::path checkpoint = tallyOf(files);
  const SkySize size = skySizeOf(loaded.scene);
  requireMemory("the picture", memoryToRender(size, loaded.scene.recon, options.run.threads));
  Transaction outputs = claimOutputs({{scene},
                                      {files.exr, files.png, options.run.stats},
                                      {},
                                      {{files.exr, leastBytesOfPicture(size, loaded.scene.recon)}}},
                                     options.run.overwrite);
  Transaction tally = claimRun({{scene}, {options.longRun.leavesCheckpoint() ? checkpoint.string() : ""}}, options.run,
                               options.longRun);
  // Also while the picture is made, so that a late Ctrl-C does not lose what was traced.
  const StopSignal stop;
  SkySums sums(loaded, cloud);
  Development picture(sums, loaded, options.run.threads);
  LongRun run({tracers, options.run, options.longRun, cloud, settings, wanted, checkpoint,
               [&] { return picture.error(&stop.requested()); }},
              sums, stop);
  run.trace();
  run.report();
  run.writeLastCheckpoint();
  if (run.endsWithoutPicture()) return run.exitCode();
  ReconstructedSky sky = picture.take();
  files.run = &outputs;
  files.threads = options.run.threads;
  files.watch = walkWatch(options.run, &stop);
  const WrittenSky written = writeSkyFiles(files, std::move(sky.image), sums.tally().info(), loaded);
  files.watch = {};
  nlohmann::ordered_json more = nlohmann::ordered_json::object();
  if (choice) more["choice"] = choiceStats(*choice);
  if (written.orders) more["orders"] = ordersJson(*written.orders);
  run.writeStats(outputs, &more);
  outputs.commit();
  if (!options.run.quiet) reportPicture(files, written, sky.remarks);
  return written.orders && written.orders->interrupted ? kInterrupted : run.exitCode();
}

}  // namespace

void addRender(CLI::App& app, int& exit, Tracers& tracers) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = app.add_subcommand("render", "Render a scene to a linear EXR and a PNG preview beside it");
  options->run.addTo(*command, true);
  options->longRun.addTo(*command, LongRunOptions::Keeps::tallyBeside);
  options->picture.addTo(*command);
  options->run.mayIntegrate = true;
  command->callback([options, command, &exit, &tracers] { exit = runRender(*options, *command, tracers); });
}

}  // namespace parhelion::cli
