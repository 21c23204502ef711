// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "csv.h"
#include "halos/closed_forms.h"
#include "halos/edge_fit.h"
#include "math/names.h"
#include "rays_configurations.h"
#include "rays_plan.h"
#include "trace/scatter_profile.h"

namespace parhelion::bench {
namespace {

constexpr Engine kEngines[] = {Engine::embree, Engine::planes};
constexpr int kBins = 320;                  // of the histogram that is fitted
constexpr double kFrom = 21.0, kTo = 22.6;  // degrees, of the widest histogram; the edge lies on no border of a bin
constexpr int kMostHalvings = 8;            // of the widest histogram
constexpr int kFineBins = kBins << kMostHalvings;
constexpr int kDraws = 25;  // of each error bar

Cloud ringCloud() {
  return cloudUnderPointSun(radians(20.0), {prisms(1.0, RandomOrientation{})}, ConstantIndex{kIndex});
}

/// How often the fit's window is halved. The edge is a step, so its position's error falls as one over the rays, not
/// over their root, and the window must shrink with it for the bins not to show.
int halvings(std::uint64_t rays) {
  return std::clamp(static_cast<int>(std::lround(2.0 * std::log10(1e-4 * static_cast<double>(rays)))), 0,
                    kMostHalvings);
}

/// A part of the fine bins about `centre` (degrees), in wider bins.
Histogram window(const std::vector<double>& fine, double centre, int halved) {
  const int merged = 1 << (kMostHalvings - halved), size = kBins * merged;
  const double step = (kTo - kFrom) / kFineBins;
  const int middle = static_cast<int>((centre - kFrom) / step);
  const int first = std::clamp(middle - size / 2, 0, kFineBins - size);
  Histogram histogram(kFrom + first * step, kFrom + (first + size) * step, kBins);
  for (int i = 0; i < size; ++i) histogram.energy[i / merged] += fine[first + i];
  return histogram;
}

/// Fits in ever narrower windows, each about the last one's edge.
double edgeOf(const std::vector<double>& fine, int halved) {
  double position = 0.5 * (kFrom + kTo);
  for (int h = halved % 2; h <= halved; h += 2) position = fitEdge(window(fine, position, h)).position;
  return position;
}

struct Position {
  double degrees, error;
};

/// The edge's position, and how far it scatters when every bin is moved by its own standard error.
Position positionOf(const ScatterProfile& profile, int halved) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::vector<double> energy;
  const auto bins = profile.bins();
  for (const auto& bin : bins) energy.push_back(bin.energy);
  SampleMean positions;
  for (int i = 0; i < kDraws; ++i) {
    std::vector<double> moved = energy;
    for (int k = 0; k < kFineBins; ++k) moved[k] += bins[k].error * normal(random);
    positions.add(edgeOf(moved, halved));
  }
  return {edgeOf(energy, halved), positions.standardError() * std::sqrt(kDraws)};
}

}  // namespace

void measureRingPosition(const RaysPlan& plan) {
  Csv csv(plan.results / "rays_ring_position.csv",
          "Inner edge of the 22 degree ring: prisms of aspect 1 in random orientation, n = 1.31, point sun, seed 1; "
          "degrees.\n"
          "error: scatter of the fit when every bin of the profile is moved by its standard error.\n"
          "The fit's window is 1.6 degrees wide at ten thousand rays and half of that for every half power of ten.",
          "engine,rays,deviation,error,exact");
  const double exact = degrees(theory::leastDeviation(radians(60.0), kIndex));
  const Cloud cloud = ringCloud();
  const std::uint64_t most = plan.quick ? 1'000'000 : 100'000'000;
  for (const Engine engine : kEngines) {
    ScatterProfile profile(kFineBins, radians(kFrom), radians(kTo));
    TraceControl control{.timeLimit = plan.quick ? 2.0 : 30.0, .onProgress = {}};
    std::uint64_t done = 0;
    // Each number of rays includes those of the one before.
    for (double rays = 1e4; rays < 1.1 * static_cast<double>(most); rays *= std::sqrt(10.0)) {
      TraceSettings settings = tracing(engine);
      settings.rays = static_cast<std::uint64_t>(std::llround(rays));
      const TraceReport report = traceRays(cloud, settings, done, profile, control);
      done += report.rays;
      const Position position = positionOf(profile, halvings(done));
      csv.row(nameOf(engine), done, position.degrees - exact, position.error, exact);
      control.timeLimit -= report.seconds;
      if (report.interrupted) break;
    }
  }
}

}  // namespace parhelion::bench
