// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <cstdio>

#include "cli/commands.h"
#include "cli/run_options.h"
#include "cli/tally_run.h"
#include "cli/text_output.h"
#include "picture/exr.h"
#include "trace/sky_map.h"

namespace parhelion::cli {

namespace {

struct MapOptions {
  RunOptions run;
  double step = 1.0;  // degrees
  std::string output = "-";

  bool toExr() const { return output.ends_with(".exr"); }
};

std::string csv(const SkyMap& map) {
  std::string text = "azimuth_deg,elevation_deg,energy,stderr\n";
  char line[120];
  for (int row = 0; row < map.rows(); ++row)
    for (int column = 0; column < map.columns(); ++column) {
      std::snprintf(line, sizeof line, "%.10g,%.10g,%.9g,%.4g\n", tableDegrees(map.azimuth(column)),
                    tableDegrees(map.elevation(row)), map.energy(column, row), map.error(column, row));
      text += line;
    }
  return text;
}

/// Channels Y (energy a bin) and stderr, the zenith's row on top.
Image image(const SkyMap& map) {
  Image image{map.columns(), map.rows(), {}};
  image.add("Y");
  image.add("stderr");
  for (int row = 0; row < map.rows(); ++row)
    for (int column = 0; column < map.columns(); ++column) {
      const std::size_t pixel = static_cast<std::size_t>(map.rows() - 1 - row) * map.columns() + column;
      image.channels[0].samples[pixel] = static_cast<float>(map.energy(column, row));
      image.channels[1].samples[pixel] = static_cast<float>(map.error(column, row));
    }
  return image;
}

int runMap(const MapOptions& options, int binsPerHalfTurn) {
  const LoadedScene loaded = options.run.loadWithoutSymmetry();
  requireOutputs(options.run.scene, {options.output, options.run.stats});
  const Cloud cloud = makeCloud(loaded.scene);
  SkyMap map(cloud.sun().toCentre(), binsPerHalfTurn);
  const StopSignal stop;
  const RunResult result = runTrace(options.run, loaded.scene, cloud, map, stop);
  if (options.toExr())
    writeBeautyExr(options.output, image(map), sceneAttributes(loaded, result.report.rays));
  else
    writeText(options.output, csv(map));
  return result.exitCode();
}

}  // namespace

void addMap(CLI::App& app, int& exit) {
  auto options = std::make_shared<MapOptions>();
  CLI::App* command = app.add_subcommand("map", "Light over azimuth and elevation of the whole sphere, as CSV or EXR");
  options->run.addTo(*command, false);
  command->add_option("--step", options->step, "Size of a bin, degrees; 90 must be a multiple of it")
      ->check(CLI::Range(0.01, 90.0));
  command->add_option("-o,--output", options->output, "CSV file, or EXR by its name; - for CSV on stdout")
      ->type_name("FILE");
  command->callback([options, &exit] {
    const double rows = 90.0 / options->step;
    if (std::abs(rows - std::round(rows)) > 1e-9 * rows)
      throw CLI::ValidationError("--step must divide 90 degrees evenly");
    exit = runMap(*options, 2 * static_cast<int>(std::round(rows)));
  });
}

}  // namespace parhelion::cli
