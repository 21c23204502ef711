// SPDX-License-Identifier: Apache-2.0
#include "cli/integral_run.h"

#include <array>
#include <string>

#include "cli/commands.h"
#include "cli/stats.h"
#include "parallel/threads.h"
#include "trace/trace_settings.h"

namespace parhelion::cli {

namespace {

constexpr std::array kOfRays{"--rays",  "--seed",      "--sampler", "--time",       "--simd", "--symmetry",
                             "--slice", "--ray-range", "--resume",  "--checkpoint", "--tally"};

}  // namespace

void refuseRayOptions(const CLI::App& command) {
  for (const char* option : kOfRays) {
    const CLI::Option* known = command.get_option_no_throw(option);
    if (known && known->count() > 0) throw Unfit(option + std::string(": the integral engine follows no rays"));
  }
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

}  // namespace parhelion::cli
