// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "csv.h"
#include "recon/compare.h"
#include "recon/reconstruct.h"
#include "recon_plan.h"
#include "recon_scenes.h"

namespace parhelion::bench {
namespace {

constexpr double kLeast = 8.0, kMost = 4096.0;  // hits

struct Curve {
  std::string name;
  double lobes;
  KernelFlow flow;
};

const Curve kCurves[] = {
    {"scatter k=1", 1.0, KernelFlow::scatter},
    {"gather k=1", 1.0, KernelFlow::gather},
    {"scatter k=2", 2.0, KernelFlow::scatter},
    {"gather k=2", 2.0, KernelFlow::gather},
};

}  // namespace

void sweepSamples(const Plan& plan) {
  const BenchScene& scene = benchScenes(plan).front();
  const Tally reference = referenceTally(plan, scene);
  const double step = plan.quick ? 16.0 : std::sqrt(2.0);
  Csv csv(plan.results / "recon_samples.csv",
          "Error against m, the hits that a square grows to hold, scene " + scene.name + "; unit gain, no iteration",
          "rays,curve,samples,relMSE,energy_error");
  for (const std::uint64_t rays : plan.rayCounts()) {
    const Tally tally = sceneTally(plan, scene, rays, 1);
    for (const Curve& curve : kCurves) {
      for (double m = kLeast; m < kMost * 1.01; m *= step) {
        const GonzatoMarchandSettings method{.samples = m, .lobes = curve.lobes, .flow = curve.flow};
        const Comparison error = compare(reconstruct(tally, method).image, reference);
        csv.row(rays, curve.name, m, error.relMse, error.energyError);
      }
    }
  }
}

}  // namespace parhelion::bench
