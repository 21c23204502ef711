// SPDX-License-Identifier: Apache-2.0
#include "cli/integral_run.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "cli/commands.h"
#include "cli/long_run_options.h"
#include "cli/say.h"
#include "cli/stats.h"
#include "parallel/threads.h"
#include "trace/trace_settings.h"

namespace parhelion::cli {

namespace {

// The error of a picture when none is asked for.
constexpr double kGoal = 0.02;

constexpr const char* kSeed = "--seed";
constexpr std::array kOfRays{"--rays", kSeed, "--sampler", "--simd", "--symmetry"};
constexpr std::array kOfLongRuns{"--time", "--slice", "--ray-range", "--resume", "--checkpoint", "--tally"};

std::string listOf(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

bool isGiven(const CLI::App& command, const char* option) {
  const CLI::Option* known = command.get_option_no_throw(option);
  return known && known->count() > 0;
}

}  // namespace

bool isIntegrated(const Scene& scene) {
  return scene.trace.engine == Engine::integral || scene.trace.engine == Engine::mixed;
}

void requireIntegrable(const Scene& scene) {
  if (scene.trace.engine == Engine::mixed) return;
  const std::string objection = objectionToIntegratedSky(scene);
  if (objection.empty()) return;
  throw Unfit("engine " + std::string(nameOf(scene.trace.engine)) + ": " + objection +
              "; rays can do it, with another engine, such as auto, or mixed for the rest alone");
}

double integralGoal(const std::string& error) { return error.empty() ? kGoal : errorGoalIn(error); }

bool asksForErrorAlone(const CLI::App& command) {
  const auto given = [&](const char* option) { return isGiven(command, option); };
  return given("--error") && std::ranges::none_of(kOfRays, given) && std::ranges::none_of(kOfLongRuns, given);
}

void refuseRayOptions(const CLI::App& command, RayOptions taken) {
  const bool someRays = taken == RayOptions::someRays;
  const auto refuse = [&](const char* option, const char* why) {
    if (isGiven(command, option)) throw Unfit(option + std::string(": ") + why);
  };
  for (const char* option : kOfLongRuns)
    refuse(option, someRays ? "the engine mixed keeps no rays" : "the integral engine follows no rays");
  if (someRays) return;
  for (const char* option : kOfRays)
    if (taken != RayOptions::seed || std::string_view(option) != kSeed)
      refuse(option, "the integral engine follows no rays");
}

nlohmann::ordered_json integralStats(double seconds, int threads, double cutOff) {
  const ProcessUsage usage = processUsage();
  nlohmann::ordered_json json;
  for (const char* none : {"rays", "hits", "deposits"}) json[none] = 0;
  json["seconds"] = seconds;
  json["cpu_seconds"] = usage.cpuSeconds;
  json["rays_per_second"] = 0.0;
  json["engine"] = nameOf(Engine::integral);
  json["threads"] = threadCount(threads);
  json["peak_memory_bytes"] = usage.peakMemory;
  json["energy"] = {{"in", 1.0}, {"out", 1.0 - cutOff}, {"absorbed", 0.0}, {"cut_off", cutOff}, {"lost", 0.0}};
  return json;
}

void reportChoice(const EngineChoice& choice) {
  say("rays are quicker for this error: about %.2g s of one thread, and %.2g s by the integral", *choice.rays(),
      choice.integral());
}

nlohmann::ordered_json choiceStats(const EngineChoice& choice) {
  nlohmann::ordered_json json{{"integral_seconds", choice.integral()}};
  if (choice.rays()) json["rays_seconds"] = *choice.rays();
  return json;
}

void reportSmooth(const MixedSky& made) {
  const IntegratedSky& sky = made.sky;
  if (made.secondsIntegrated > 0.0) {
    say("%ld sheets of orientations from %ld directions in %.2f s: mean relative error %.2g", sky.sheets,
        sky.directions, made.secondsIntegrated, sky.error);
    say("energy: in 1 = out %.9f + cut off %.3g", 1.0 - sky.cutOff, sky.cutOff);
  }
  if (!made.traced.empty() && made.tracedShare > 0.0)
    say("rays for %.3g %% of the light in %.2f s: %s", 100.0 * made.tracedShare, made.secondsTraced,
        listOf(made.traced).c_str());
}

nlohmann::ordered_json smoothStats(const MixedSky& made, double seconds, int threads, Engine engine) {
  const IntegratedSky& sky = made.sky;
  nlohmann::ordered_json json = integralStats(seconds, threads, sky.cutOff);
  json["engine"] = nameOf(engine);
  json["directions"] = sky.directions;
  json["sheets"] = sky.sheets;
  json["error"] = sky.error;
  json["reached"] = sky.reached;
  if (engine != Engine::mixed) return json;
  json["rays"] = sky.info.rayCount();
  json["integrated"] = made.integrated;
  json["traced"] = made.traced;
  json["traced_light"] = made.tracedShare;
  return json;
}

}  // namespace parhelion::cli
