// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace parhelion::bench {

/// How much of tracing is measured, and where things are.
struct RaysPlan {
  bool quick = false;
  std::filesystem::path source;   // root of the repository
  std::filesystem::path tallies;  // references traced already, or to be
  std::filesystem::path results;  // for tables

  /// Seconds that one measurement of speed takes.
  double seconds() const { return quick ? 0.2 : 1.2; }
};

// The parts of the benchmark, each writing files of its own into the plan's results.

/// Speed of each engine against how often it names a wrong face or none.
void measureEngines(const RaysPlan& plan);
/// Error of the picture against the time of its rays.
void measureErrorByTime(const RaysPlan& plan);
/// Error of whole pictures against their time: rays, reconstructions, and pictures without rays.
void measureIntegral(const RaysPlan& plan);
/// Speed and memory against threads and picture size, and the ways in which threads may share a tally.
void measureScaling(const RaysPlan& plan);
/// Where the inner edge of the 22 degree ring is found, by the number of rays.
void measureRingPosition(const RaysPlan& plan);
/// CPU time for 1 % noise a pixel in the 22 degree ring: plain, mirrored, in rings.
void measureQuality(const RaysPlan& plan);
/// How the stages of tracing share the time, and how far the search for faces is from a bare loop of it.
void measureStages(const RaysPlan& plan);
/// Speed and wrong faces of the ways in which Embree may be asked for the next face.
void measureEmbree(const RaysPlan& plan);

}  // namespace parhelion::bench
