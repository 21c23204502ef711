// SPDX-License-Identifier: Apache-2.0
#include "recon_methods.h"

#include <array>

#include "math/names.h"

namespace parhelion::bench {
namespace {

constexpr int kTimings = 3;
constexpr double kSlow = 2.0;  // s, from which on other programs' share of a single run is small

}  // namespace

std::string Contender::methodName() const { return std::string(nameOf(method)); }

std::span<const Contender> contenders() {
  static const std::array<Contender, 11> all{{
      {"none", "plain", "", NoSettings{}},
      {"gaussian", "one Gaussian", "", GaussianSettings{}},
      {"glassner", "Glassner", "", GlassnerSettings{}},
      {"marvasti", "Marvasti", "", MarvastiSettings{}},
      {"voronoi", "Voronoi densities", "", VoronoiSettings{}},
      {"voronoi-intensities", "Voronoi intensities", "reading=intensities iterations=3",
       VoronoiSettings{.reading = HitReading::intensities, .period = {}, .iterations = 3}},
      {"act", "ACT", "", ActSettings{}},
      {"published", "Gonzato-Marchand as published", "gain=paper flow=gather samples=16",
       GonzatoMarchandSettings{.samples = 16.0, .gain = KernelGain::paper, .flow = KernelFlow::gather}},
      {"gather", "Gonzato-Marchand gather", "flow=gather",
       GonzatoMarchandSettings{.samples = {}, .flow = KernelFlow::gather}},
      {"scatter", "Gonzato-Marchand scatter", "", GonzatoMarchandSettings{}},
      {"adaptive", "adaptive", "", AdaptiveSettings{}},
  }};
  return all;
}

TimedSky timedSky(const Plan& plan, const Tally& tally, const ReconSettings& method) {
  Stopwatch first;
  TimedSky result{reconstruct(tally, method), {}};
  result.timing = first.read();
  if (plan.quick || result.timing.seconds > kSlow) return result;
  for (int i = 0; i < kTimings; ++i) {
    Stopwatch again;
    result.sky = reconstruct(tally, method);
    const Timing timing = again.read();
    if (i == 0 || timing.seconds < result.timing.seconds) result.timing = timing;
  }
  return result;
}

}  // namespace parhelion::bench
