// SPDX-License-Identifier: Apache-2.0
#include "csv.h"
#include "recon/compare.h"
#include "recon/reconstruct.h"
#include "recon_plan.h"
#include "recon_scenes.h"

namespace parhelion::bench {
namespace {

struct Curve {
  std::string name;
  std::function<ReconSettings(int iterations)> method;
};

std::vector<Curve> curves() {
  std::vector<Curve> all;
  for (const double m : {32.0, 128.0, 512.0, 2048.0})
    all.push_back({"scatter m=" + std::to_string(static_cast<int>(m)),
                   [m](int iterations) { return GonzatoMarchandSettings{.samples = m, .iterations = iterations}; }});
  all.push_back({"marvasti", [](int iterations) { return MarvastiSettings{.period = {}, .iterations = iterations}; }});
  all.push_back({"voronoi", [](int iterations) { return VoronoiSettings{.period = {}, .iterations = iterations}; }});
  return all;
}

std::vector<int> iterationCounts(const Plan& plan) {
  if (plan.quick) return {0, 3};
  return {0, 1, 2, 3, 4, 5, 6, 8, 10, 12, 15, 20};
}

}  // namespace

void sweepIterations(const Plan& plan) {
  const BenchScene& scene = benchScenes(plan).front();
  const Tally reference = referenceTally(plan, scene);
  Csv csv(plan.results / "recon_iterations.csv",
          "Error against the number of Allebach's iterations, scene " + scene.name +
              "; stopped: 1 where the residual "
              "grew and an earlier picture was kept",
          "rays,curve,iterations,relMSE,energy_error,stopped");
  for (const std::uint64_t rays : {100'000, 1'000'000}) {
    const Tally tally = sceneTally(plan, scene, rays, 1);
    for (const Curve& curve : curves()) {
      for (const int iterations : iterationCounts(plan)) {
        const ReconstructedSky sky = reconstruct(tally, curve.method(iterations));
        const Comparison error = compare(sky.image, reference);
        bool stopped = false;
        for (const std::string& remark : sky.remarks) stopped = stopped || remark.find("stopped") != std::string::npos;
        csv.row(rays, curve.name, iterations, error.relMse, error.energyError, stopped);
      }
    }
  }
}

}  // namespace parhelion::bench
