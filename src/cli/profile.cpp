// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cstdio>

#include <nlohmann/json.hpp>

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
#include "parallel/run_clock.h"
#include "parallel/threads.h"
#include "picture/memory_limit.h"
#include "render/integrated_profile.h"
#include "render/measured_sums.h"
#include "render/measured_tally.h"
#include "render/measurements.h"
#include "render/needs.h"

namespace parhelion::cli {

namespace {

struct ProfileOptions {
  RunOptions run;
  LongRunOptions longRun;
  int bins = 1800;
  double from = 0.0, to = 180.0;  // degrees
  std::string output = "-", summary;
  std::string error;  // aimed at by the integral engine; empty: as chosen
};

std::string csv(const std::vector<ScatterProfile::Bin>& bins) {
  std::string text = kProfileColumns + std::string("\n");
  char line[160];
  for (const ScatterProfile::Bin& bin : bins) {
    std::snprintf(line, sizeof line, "%.10g,%.10g,%.9g,%.4g,%.9g\n", tableDegrees(bin.from), tableDegrees(bin.to),
                  bin.energy, bin.error, bin.phase);
    text += line;
  }
  return text;
}

nlohmann::ordered_json json(const ScatterProfile::Summary& s) {
  nlohmann::ordered_json json;
  json["rays"] = s.rays;
  json["g"] = s.g;
  json["g_stderr"] = s.gError;
  json["delta"] = s.undeviated;
  json["external"] = s.external;
  json["by_order"] = s.byOrder;
  json["by_order_rest"] = s.byOrderRest;
  json["mean_path"] = s.meanPath;
  json["mean_path_stderr"] = s.meanPathError;
  json["volume"] = s.volume;
  json["surface"] = s.surface;
  json["mean_projected_area"] = s.meanProjectedArea;
  json["cut_off"] = s.cutOff;
  json["lost"] = s.lost;
  return json;
}

double outOf(const IntegratedProfile& profile) { return 1.0 - profile.filtered - profile.summary.cutOff; }

nlohmann::ordered_json statsOf(const IntegratedProfile& profile, double seconds, int threads) {
  nlohmann::ordered_json json = integralStats(seconds, threads, profile.summary.cutOff);
  json["energy"]["out"] = outOf(profile);
  json["energy"]["filtered"] = profile.filtered;
  json["directions"] = profile.directions;
  json["patches"] = profile.patches;
  json["reached"] = profile.reached;
  return json;
}

int runIntegral(const ProfileOptions& options, const CLI::App& command, const Scene& scene) {
  refuseRayOptions(command);
  if (const std::string objection = objectionToIntegral(scene); !objection.empty())
    throw Unfit("engine integral: " + objection + "; rays can do it, with another engine, such as auto");
  IntegralProfileSettings settings{options.bins, radians(options.from), radians(options.to)};
  if (!options.error.empty()) settings.error = errorGoalIn(options.error);
  settings.detailed = !options.summary.empty();
  requireMemory("the profile", memoryToIntegrate(options.bins, options.run.threads));
  Transaction outputs =
      claimOutputs({{options.run.scene}, {options.output, options.summary, options.run.stats}}, options.run.overwrite);
  const RunClock clock;
  const IntegratedProfile profile = withThreads(options.run.threads, [&] { return integrateProfile(scene, settings); });
  const double seconds = clock.seconds();
  if (!options.run.quiet) {
    say("%ld directions in %.2f s, %.3g a second", profile.directions, seconds, profile.directions / seconds);
    char filtered[40] = "";
    if (profile.filtered > 0.0) std::snprintf(filtered, sizeof filtered, " + filtered %.9f", profile.filtered);
    say("energy: in 1 = out %.9f%s + cut off %.3g", outOf(profile), filtered, profile.summary.cutOff);
  }
  if (!profile.reached)
    say("warning: --error was not reached at the finest mesh; the table has the errors as they are");
  writeText(outputs.at(options.output), csv(profile.bins));
  if (!options.summary.empty()) writeJson(outputs.at(options.summary), json(profile.summary));
  if (!options.run.stats.empty())
    writeJson(outputs.at(options.run.stats), statsOf(profile, seconds, options.run.threads));
  outputs.commit();
  return kDone;
}

int runProfile(const ProfileOptions& options, const CLI::App& command, Tracers& tracers) {
  LoadedScene loaded = options.run.load();
  if (asksForErrorAlone(command) && loaded.scene.trace.engine == Engine::automatic)
    loaded.scene.trace.engine = Engine::integral;
  if (loaded.scene.trace.engine == Engine::integral) return runIntegral(options, command, loaded.scene);
  if (loaded.scene.trace.engine == Engine::mixed)
    throw Unfit("engine mixed: it makes pictures and maps; profiles take rays, or the engine integral");
  if (!options.error.empty()) throw Unfit("--error: it is for light that is integrated; rays take --rays or --time");
  const Cloud cloud = cloudByLight(loaded.scene);
  const TraceSettings settings = settingsOfMeasurement(cloud, loaded.scene.trace);
  const RayRange wanted = options.longRun.wanted(settings.rays, cloud.bundleSize(), options.run);
  const std::string tally = options.longRun.tallyFile();
  requireMemory("the profile", memoryToProfile(options.bins, options.run.threads));
  Transaction outputs = claimRun({{options.run.scene}, {options.output, options.summary, tally, options.run.stats}},
                                 options.run, options.longRun);
  const StopSignal stop;
  MeasuredSums<ProfileTally> sums(
      [&] { return emptyProfileTally(loaded, cloud, options.bins, radians(options.from), radians(options.to)); });
  LongRun run({tracers, options.run, options.longRun, cloud, settings, wanted, tally, {}}, sums, stop);
  run.trace();
  run.report();
  if (!tally.empty()) run.writeSums(outputs.at(tally));
  if (!run.endsWithoutPicture()) {
    const ScatterProfile& profile = sums.tally().sums;
    writeText(outputs.at(options.output), csv(profile.bins()));
    if (!options.summary.empty()) writeJson(outputs.at(options.summary), json(profile.summary()));
  }
  run.writeStats(outputs);
  outputs.commit();
  return run.exitCode();
}

/// The table of a tally that was traced before.
int profileOfTally(const ProfileOptions& options) {
  requireMeasured(options.run, TallyKind::profile);
  Transaction outputs = claimOutputs({{options.run.scene}, {options.output, options.summary}}, options.run.overwrite);
  const ProfileTally tally = readProfileTally(options.run.scene);
  writeText(outputs.at(options.output), csv(tally.sums.bins()));
  if (!options.summary.empty()) writeJson(outputs.at(options.summary), json(tally.sums.summary()));
  outputs.commit();
  return kDone;
}

}  // namespace

void addProfile(CLI::App& app, int& exit, Tracers& tracers) {
  auto options = std::make_shared<ProfileOptions>();
  CLI::App* command = app.add_subcommand(
      "profile",
      "Light over the scattering angle, from each ray's own point of the sun, as CSV, and what follows from it");
  options->run.addTo(*command, false);
  options->longRun.addTo(*command, LongRunOptions::Keeps::tallyByName);
  command->add_option("--bins", options->bins, "Equal bins between --from and --to")
      ->transform(wholeNumber(1, 10'000'000));
  command->add_option("--from", options->from, "First scattering angle, degrees")->transform(number(0.0, 180.0));
  command->add_option("--to", options->to, "Last scattering angle, degrees")->transform(number(0.0, 180.0));
  command->add_option("-o,--output", options->output, "CSV file; - for stdout")->type_name("FILE");
  command->add_option("--summary", options->summary, "JSON file of g, delta fraction, energy by order, mean path ...")
      ->type_name("FILE");
  addErrorGoal(*command, options->error,
               "Integrate, as --engine integral does, and aim at this relative error of bins, as the root of its mean "
               "square; the engine takes 1% when it is left out");
  options->run.mayIntegrate = true;
  command->callback([options, command, &exit, &tracers] {
    if (isMeasuredTally(options->run.scene)) {
      for (const char* bins : {"--bins", "--from", "--to", "--error"})
        if (command->count(bins) > 0) throw Unfit(bins + std::string(": the bins of a tally are what they are"));
      exit = profileOfTally(*options);
      return;
    }
    if (!(options->from < options->to)) throw CLI::ValidationError("--from must be less than --to");
    exit = runProfile(*options, *command, tracers);
  });
}

}  // namespace parhelion::cli
