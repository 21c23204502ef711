// SPDX-License-Identifier: Apache-2.0
// Accuracy against time of the reconstruction methods. scripts/bench runs it and draws the charts.
#include <cstdio>
#include <exception>
#include <string>

#include "recon_plan.h"

using namespace parhelion::bench;

int main(int count, char** arguments) {
  if (count < 4) {
    std::fprintf(stderr, "usage: bench_recon SOURCE TALLIES RESULTS [--quick]\n");
    return 2;
  }
  const Plan plan{count > 4 && std::string(arguments[4]) == "--quick", arguments[1], arguments[2], arguments[3]};
  try {
    std::filesystem::create_directories(plan.tallies);
    std::filesystem::create_directories(plan.results);
    for (const auto part : {measureAccuracy, sweepIterations, sweepSamples, drawSignal, drawPictures}) part(plan);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_recon: %s\n", error.what());
    return 1;
  }
  return 0;
}
