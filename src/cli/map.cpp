// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>

#include "cli/commands.h"
#include "cli/integral_run.h"
#include "cli/long_run.h"
#include "cli/number_options.h"
#include "cli/outputs.h"
#include "cli/run_options.h"
#include "cli/say.h"
#include "cli/stats.h"
#include "cli/tables.h"
#include "cli/tally_input.h"
#include "cli/text_output.h"
#include "cli/trace_watch.h"
#include "parallel/run_clock.h"
#include "picture/exr.h"
#include "picture/memory_limit.h"
#include "picture/photograph.h"
#include "render/measured_sums.h"
#include "render/measured_tally.h"
#include "render/measurements.h"
#include "render/mixed_sky.h"
#include "render/needs.h"
#include "render/scene_attributes.h"

namespace parhelion::cli {

namespace {

struct MapOptions {
  RunOptions run;
  LongRunOptions longRun;
  double step = 1.0;  // degrees
  std::string output = "-";
  std::string error;  // aimed at where light is integrated; empty: as chosen

  bool toExr() const { return extensionOf(output) == ".exr"; }
};

std::string csv(const LightMap& map) {
  std::string text = kMapColumns + std::string("\n");
  char line[120];
  for (int row = 0; row < map.grid.rows(); ++row)
    for (int column = 0; column < map.grid.columns(); ++column) {
      const auto bin = static_cast<std::size_t>(map.grid.bin(column, row));
      std::snprintf(line, sizeof line, "%.10g,%.10g,%.9g,%.4g\n", tableDegrees(map.grid.azimuth(column)),
                    tableDegrees(map.grid.elevation(row)), map.energy[bin], map.error[bin]);
      text += line;
    }
  return text;
}

void writeMap(const MapOptions& options, const LightMap& map, const LoadedScene& loaded, std::uint64_t rays,
              Transaction& outputs) {
  if (options.toExr())
    writeBeautyExr(outputs.at(options.output), mapPicture(map), sceneAttributes(loaded, rays));
  else
    writeText(outputs.at(options.output), csv(map));
}

/// Makes a map without rays, or with rays for some populations alone.
int runSmooth(const MapOptions& options, const CLI::App& command, int binsPerHalfTurn, LoadedScene loaded) {
  const Engine engine = loaded.scene.trace.engine;
  const bool mixed = engine == Engine::mixed;
  refuseRayOptions(command, mixed ? RayOptions::someRays : RayOptions::none);
  if (2 * binsPerHalfTurn * pixelsPerBin(binsPerHalfTurn) > kMaxImageSide)
    throw Unfit("--step: the integral engine has no bins as small as that");
  const LoadedScene whole = sceneOfMap(loaded, binsPerHalfTurn);
  requireIntegrable(whole.scene);
  const double goal = integralGoal(options.error);
  requireMemory("the map", memoryToIntegrate(skySizeOf(whole.scene)) + memoryOfOrientations(whole.scene, goal) +
                               memoryToMap(binsPerHalfTurn, options.run.threads));
  Transaction outputs = claimOutputs({{options.run.scene},
                                      {options.output, options.run.stats},
                                      {},
                                      {{options.output, leastBytesOfMap(binsPerHalfTurn, !options.toExr())}}},
                                     options.run.overwrite);
  loaded.error = goal;
  const RunClock clock;
  const StopSignal stop;
  const auto [light, made] = mixMap(loaded, binsPerHalfTurn, goal, traceControl(options.run, &stop));
  const double seconds = clock.seconds();
  if (made.report.interrupted) return kInterrupted;
  if (!options.run.quiet) reportSmooth(made);
  if (!made.sky.reached) say("warning: the error asked for was not reached; the map has its errors as they are");
  writeMap(options, light, loaded, made.sky.info.rayCount(), outputs);
  if (!options.run.stats.empty())
    writeJson(outputs.at(options.run.stats), smoothStats(made, seconds, options.run.threads, engine));
  outputs.commit();
  return kDone;
}

int runMap(const MapOptions& options, const CLI::App& command, int binsPerHalfTurn, Tracers& tracers) {
  LoadedScene loaded = options.run.load();
  if (asksForErrorAlone(command)) loaded.scene.trace.engine = integratingEngine(loaded.scene);
  if (isIntegrated(loaded.scene)) return runSmooth(options, command, binsPerHalfTurn, loaded);
  if (!options.error.empty()) throw Unfit("--error: it is for light that is integrated; rays take --rays or --time");
  const Cloud cloud = cloudByLight(loaded.scene);
  const TraceSettings settings = settingsOfMeasurement(cloud, loaded.scene.trace);
  const RayRange wanted = options.longRun.wanted(settings.rays, cloud.bundleSize(), options.run);
  const std::string tally = options.longRun.tallyFile();
  requireMemory("the map", memoryToMap(binsPerHalfTurn, options.run.threads));
  Transaction outputs = claimRun({{options.run.scene},
                                  {options.output, tally, options.run.stats},
                                  {},
                                  {{options.output, leastBytesOfMap(binsPerHalfTurn, !options.toExr())}}},
                                 options.run, options.longRun);
  const StopSignal stop;
  MeasuredSums<MapTally> sums([&] { return emptyMapTally(loaded, cloud, binsPerHalfTurn); });
  LongRun run({tracers, options.run, options.longRun, cloud, settings, wanted, tally, {}}, sums, stop);
  run.trace();
  run.report();
  if (!tally.empty()) run.writeSums(outputs.at(tally));
  if (!run.endsWithoutPicture())
    writeMap(options, sums.tally().sums.light(), loaded, sums.origin().rayCount(), outputs);
  run.writeStats(outputs);
  outputs.commit();
  return run.exitCode();
}

/// The table of a tally that was traced before.
int mapOfTally(const MapOptions& options) {
  requireMeasured(options.run, TallyKind::map);
  Transaction outputs = claimOutputs({{options.run.scene}, {options.output}}, options.run.overwrite);
  const MapTally tally = readMapTally(options.run.scene);
  const LoadedScene loaded = parseScene(tally.origin.scene, "the scene in " + options.run.scene);
  writeMap(options, tally.sums.light(), loaded, tally.origin.rayCount(), outputs);
  outputs.commit();
  return kDone;
}

}  // namespace

void addMap(CLI::App& app, int& exit, Tracers& tracers) {
  auto options = std::make_shared<MapOptions>();
  CLI::App* command = app.add_subcommand(
      "map", "Light over azimuth and elevation of the whole sphere, as CSV or EXR, of a scene or a tally");
  options->run.addTo(*command, false);
  options->longRun.addTo(*command, LongRunOptions::Keeps::tallyByName);
  command->add_option("--step", options->step, "Size of a bin, degrees; 90 must be a multiple of it")
      ->transform(number(0.01, 90.0));
  command->add_option("-o,--output", options->output, "CSV file, or EXR by its name; - for CSV on stdout")
      ->type_name("FILE");
  addErrorGoal(
      *command, options->error,
      "Integrate what can be, as --engine mixed does, and aim at this error, of all bins together over their light; "
      "engines that integrate take 2% when it is left out");
  options->run.mayIntegrate = true;
  command->callback([options, command, &exit, &tracers] {
    if (isMeasuredTally(options->run.scene)) {
      for (const char* bins : {"--step", "--error"})
        if (command->count(bins) > 0) throw Unfit(bins + std::string(": the bins of a tally are what they are"));
      exit = mapOfTally(*options);
      return;
    }
    constexpr double kRounding = 1e-9;  // relative; steps such as 0.1 are not exact in binary
    const double rows = 90.0 / options->step;
    if (std::abs(rows - std::round(rows)) > kRounding * rows)
      throw CLI::ValidationError("--step must divide 90 degrees evenly");
    exit = runMap(*options, *command, 2 * static_cast<int>(std::round(rows)), tracers);
  });
}

}  // namespace parhelion::cli
