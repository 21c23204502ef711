// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace parhelion::bench {

/// How much is measured, and where things are.
struct Plan {
  bool quick = false;
  std::filesystem::path source;   // root of the repository
  std::filesystem::path tallies;  // traced already, or to be
  std::filesystem::path results;  // for tables and pictures

  std::vector<std::uint64_t> rayCounts() const {
    if (quick) return {10'000, 100'000, 1'000'000};
    return {10'000, 100'000, 1'000'000, 10'000'000};
  }

  /// How many independent tallies of so many rays are tried.
  int repeats(std::uint64_t rays) const { return quick || rays >= 10'000'000 ? 1 : 2; }
};

// The parts of the benchmark, each writing files of its own into the plan's results.

/// Error and time of every method for every scene and number of rays.
void measureAccuracy(const Plan& plan);
/// Error against the number of Allebach's iterations.
void sweepIterations(const Plan& plan);
/// Error against the number of hits in a square of Gonzato and Marchand.
void sweepSamples(const Plan& plan);
/// A signal of one dimension, as each named method sees it.
void drawSignal(const Plan& plan);
/// A part of the sky as each method sees it.
void drawPictures(const Plan& plan);

}  // namespace parhelion::bench
