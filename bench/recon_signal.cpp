// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "csv.h"
#include "math/overloaded.h"
#include "math/portable.h"
#include "random_stream.h"
#include "recon/methods.h"
#include "recon_methods.h"

namespace parhelion::bench {
namespace {

constexpr int kSamples = 512;
constexpr std::uint64_t kSeed = 4;

/// Expected hits of a sample: a smooth part, a step and a peak.
double expected(int x) {
  const double smooth = x < 256 ? 0.6 * (1.0 - portable::cos(2.0 * kPi * x / 256.0)) + 0.1 : 0.1;
  const double step = x >= 256 && x < 352 ? 1.5 : 0.0;
  const double offset = (x - 432) / 4.0;
  return smooth + step + 8.0 * portable::exp(-0.5 * offset * offset);
}

/// A Poisson number by Knuth's product of uniform numbers.
int poisson(double mean, RandomStream& random) {
  const double end = portable::exp(-mean);
  int count = -1;
  for (double product = 1.0; product > end; ++count) product *= random.next();
  return count;
}

/// The defaults suit pictures; these a signal of so many hits.
const Contender kContenders[] = {
    {"gaussian", "", "sigma=4", GaussianSettings{4.0}},
    {"glassner", "", "", GlassnerSettings{}},
    {"marvasti", "", "period=8", MarvastiSettings{.period = 8.0}},
    {"voronoi", "", "period=6", VoronoiSettings{.period = 6.0}},
    {"voronoi-intensities", "", "reading=intensities period=6 iterations=3",
     VoronoiSettings{.reading = HitReading::intensities, .period = 6.0, .iterations = 3}},
    {"act", "", "period=8", ActSettings{.period = 8.0}},
    {"published", "", "gain=paper flow=gather samples=16",
     GonzatoMarchandSettings{.samples = 16.0, .gain = KernelGain::paper, .flow = KernelFlow::gather}},
    {"gather", "", "flow=gather samples=16", GonzatoMarchandSettings{.samples = 16.0, .flow = KernelFlow::gather}},
    {"scatter", "", "samples=16", GonzatoMarchandSettings{.samples = 16.0}},
};

HitMap signalHits() {
  HitMap map;
  map.lights.emplace_back(kSamples, 1);
  map.omega = Raster<double>(kSamples, 1, 1.0);
  for (int x = 0; x < kSamples; ++x) {
    RandomStream random(kSeed, static_cast<std::uint64_t>(x), RandomPurpose::pilot);
    map.lights[0].at(x, 0) = poisson(expected(x), random);
  }
  return map;
}

Reconstruction reconstructSignal(const HitMap& map, const ReconSettings& method) {
  return std::visit(
      [&](const auto& own) {
        if constexpr (requires { reconstructHits(map, own, {}); }) return reconstructHits(map, own, {});
        // The adaptive filters are made for the sky alone.
        else
          return Reconstruction{map.lights, {}};
      },
      method);
}

}  // namespace

void drawSignal(const Plan& plan) {
  const HitMap map = signalHits();
  std::string comment = "Hits of one dimension: expected and drawn ones of each sample, and what methods make of them.";
  std::string columns = "sample,expected,hits";
  std::vector<Reconstruction> results;
  for (const Contender& contender : kContenders) {
    comment += "\n" + contender.id + ": " + contender.methodName() + " " + contender.settings;
    columns += "," + contender.id;
    results.push_back(reconstructSignal(map, contender.method));
  }
  Csv csv(plan.results / "recon_signal.csv", comment, columns);
  for (int x = 0; x < kSamples; ++x) {
    std::ostringstream reconstructed;
    const char* separator = "";
    for (const Reconstruction& result : results) {
      reconstructed << separator << result.lights[0].at(x, 0);
      separator = ",";
    }
    csv.row(x, expected(x), map.hits().at(x, 0), reconstructed.str());
  }
}

}  // namespace parhelion::bench
