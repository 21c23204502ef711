// SPDX-License-Identifier: Apache-2.0

#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/run_options.h"
#include "cli/say.h"
#include "cli/trace_watch.h"
#include "picture/memory_limit.h"
#include "render/needs.h"
#include "sky/tally_exr.h"

namespace parhelion::cli {

namespace {

struct TraceOptions {
  RunOptions run;
  std::string output;
};

int runTrace(const TraceOptions& options) {
  const LoadedScene loaded = options.run.load();
  const SkySize size = skySizeOf(loaded.scene);
  requireMemory("the tally", memoryToTrace(size, options.run.threads));
  Transaction outputs = claimOutputs(
      {{options.run.scene}, {options.output, options.run.stats}, {}, {{options.output, leastBytesOfTally(size)}}},
      options.run.overwrite);
  const StopSignal stop;
  TraceWatch watch(options.run, loaded.scene.trace.rays, &stop);
  const TracedSky traced = traceSky(loaded, cloudOf(loaded.scene), watch.control());
  const int exit = watch.report(traced, outputs);
  writeTallyExr(outputs.at(options.output), traced.tally);
  outputs.commit();
  if (!options.run.quiet) say("wrote %s", options.output.c_str());
  return exit;
}

}  // namespace

void addTrace(CLI::App& app, int& exit) {
  auto options = std::make_shared<TraceOptions>();
  CLI::App* command =
      app.add_subcommand("trace", "Trace a scene into a tally EXR: exact sums a pixel, not yet a picture");
  options->run.addTo(*command, true);
  command->add_option("-o,--output", options->output, "The tally, an EXR; - for stdout")->type_name("FILE")->required();
  command->callback([options, &exit] { exit = runTrace(*options); });
}

}  // namespace parhelion::cli
