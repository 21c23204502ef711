// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>

#include "cli/commands.h"
#include "cli/long_run.h"
#include "cli/number_options.h"
#include "cli/outputs.h"
#include "cli/run_options.h"
#include "cli/tables.h"
#include "cli/tally_input.h"
#include "cli/text_output.h"
#include "picture/exr.h"
#include "picture/memory_limit.h"
#include "picture/photograph.h"
#include "render/measured_sums.h"
#include "render/measured_tally.h"
#include "render/measurements.h"
#include "render/needs.h"
#include "render/scene_attributes.h"

namespace parhelion::cli {

namespace {

struct MapOptions {
  RunOptions run;
  LongRunOptions longRun;
  double step = 1.0;  // degrees
  std::string output = "-";

  bool toExr() const { return extensionOf(output) == ".exr"; }
};

std::string csv(const SkyMap& map) {
  std::string text = kMapColumns + std::string("\n");
  char line[120];
  for (int row = 0; row < map.rows(); ++row)
    for (int column = 0; column < map.columns(); ++column) {
      std::snprintf(line, sizeof line, "%.10g,%.10g,%.9g,%.4g\n", tableDegrees(map.azimuth(column)),
                    tableDegrees(map.elevation(row)), map.energy(column, row), map.error(column, row));
      text += line;
    }
  return text;
}

int runMap(const MapOptions& options, int binsPerHalfTurn, Tracers& tracers) {
  const LoadedScene loaded = options.run.load();
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
  if (!run.endsWithoutPicture()) {
    const SkyMap& map = sums.tally().sums;
    if (options.toExr())
      writeBeautyExr(outputs.at(options.output), mapPicture(map), sceneAttributes(loaded, sums.origin().rayCount()));
    else
      writeText(outputs.at(options.output), csv(map));
  }
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
  if (options.toExr())
    writeBeautyExr(outputs.at(options.output), mapPicture(tally.sums),
                   sceneAttributes(loaded, tally.origin.rayCount()));
  else
    writeText(outputs.at(options.output), csv(tally.sums));
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
  command->callback([options, command, &exit, &tracers] {
    if (isMeasuredTally(options->run.scene)) {
      if (command->count("--step") > 0) throw Unfit("--step: the bins of a tally are what they are");
      exit = mapOfTally(*options);
      return;
    }
    constexpr double kRounding = 1e-9;  // relative; steps such as 0.1 are not exact in binary
    const double rows = 90.0 / options->step;
    if (std::abs(rows - std::round(rows)) > kRounding * rows)
      throw CLI::ValidationError("--step must divide 90 degrees evenly");
    exit = runMap(*options, 2 * static_cast<int>(std::round(rows)), tracers);
  });
}

}  // namespace parhelion::cli
