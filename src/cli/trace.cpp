// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "cli/commands.h"
#include "cli/long_run.h"
#include "cli/outputs.h"
#include "cli/say.h"
#include "picture/memory_limit.h"
#include "render/needs.h"
#include "render/sky_sums.h"
#include "sky/picture_error.h"

namespace parhelion::cli {

namespace {

struct TraceOptions {
  RunOptions run;
  LongRunOptions longRun;
  std::string output;  // empty: the tally that is gone on from
};

int runTrace(const TraceOptions& options, Tracers& tracers) {
  const std::string& output = options.output.empty() ? options.longRun.resume : options.output;
  if (output.empty()) throw CLI::RequiredError("-o FILE, or --resume FILE,");
  const LoadedScene loaded = options.run.load();
  const Cloud cloud = cloudOf(loaded.scene);
  const TraceSettings settings = chosenSettings(cloud, loaded.scene.trace);
  const RayRange wanted = options.longRun.wanted(settings.rays, cloud.bundleSize(), options.run);
  const SkySize size = skySizeOf(loaded.scene);
  requireMemory("the tally", memoryToTrace(size, options.run.threads));
  Transaction outputs =
      claimRun({{options.run.scene}, {output, options.run.stats}, {}, {{output, leastBytesOfTally(size)}}}, options.run,
               options.longRun);
  const StopSignal stop;
  SkySums sums(loaded, cloud);
  const std::string checkpoint = isStream(output) ? "" : output;
  LongRun run({tracers, options.run, options.longRun, cloud, settings, wanted, checkpoint,
               [&] { return std::optional(plainError(sums.tally().flattened())); }},
              sums, stop);
  run.trace();
  run.report();
  run.writeSums(outputs.at(output));
  run.writeStats(outputs);
  outputs.commit();
  if (!options.run.quiet) say("wrote %s", output.c_str());
  return run.exitCode();
}

}  // namespace

void addTrace(CLI::App& app, int& exit, Tracers& tracers) {
  auto options = std::make_shared<TraceOptions>();
  CLI::App* command =
      app.add_subcommand("trace", "Trace a scene into a tally EXR: exact sums a pixel, not yet a picture");
  options->run.addTo(*command, true);
  options->longRun.addTo(*command, LongRunOptions::Keeps::output);
  command->add_option("-o,--output", options->output, "The tally, an EXR; - for stdout; that of --resume when left out")
      ->type_name("FILE");
  command->callback([options, &exit, &tracers] { exit = runTrace(*options, tracers); });
}

}  // namespace parhelion::cli
