// SPDX-License-Identifier: Apache-2.0
// Speed and accuracy of tracing. scripts/bench runs it and draws the charts.
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <utility>

#include "rays_plan.h"
#include "stopwatch.h"

using namespace parhelion::bench;

namespace {

constexpr std::pair<std::string_view, void (*)(const RaysPlan&)> kParts[] = {
    {"engines", measureEngines}, {"error_by_time", measureErrorByTime},
    {"scaling", measureScaling}, {"ring_position", measureRingPosition},
    {"quality", measureQuality}, {"stages", measureStages},
    {"embree", measureEmbree},   {"integral", measureIntegral},
};

}  // namespace

int main(int count, char** arguments) {
  if (count < 4) {
    std::fprintf(stderr, "usage: bench_rays SOURCE TALLIES RESULTS [--quick] [PART]\n");
    return 2;
  }
  RaysPlan plan{false, arguments[1], arguments[2], arguments[3]};
  std::string only;
  for (int i = 4; i < count; ++i) {
    if (std::string_view(arguments[i]) == "--quick")
      plan.quick = true;
    else
      only = arguments[i];
  }
  try {
    std::filesystem::create_directories(plan.tallies);
    std::filesystem::create_directories(plan.results);
    for (const auto& [name, part] : kParts) {
      if (!only.empty() && only != name) continue;
      const Stopwatch watch;
      part(plan);
      std::fprintf(stderr, "%s: %.1f s\n", std::string(name).c_str(), watch.read().seconds);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_rays: %s\n", error.what());
    return 1;
  }
  return 0;
}
