// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "csv.h"
#include "math/names.h"
#include "recon_plan.h"
#include "recon_scenes.h"
#include "recon_summary.h"

namespace parhelion::bench {
namespace {

std::string comment(const Plan& plan) {
  std::string text = "512 x 512 pixels; reference rays:";
  for (const BenchScene& scene : benchScenes(plan))
    text += " " + scene.name + " " + std::to_string(referenceRays(plan, scene));
  return text + "\nseconds of the reconstruction alone: the best of 3 after a warm-up, of 1 for slow ones";
}

/// All methods on one tally.
void tryAll(const Plan& plan, const BenchScene& scene, const Tally& tally, const Tally& reference,
            std::vector<Trial>& trials, Csv& csv) {
  const std::string_view projection = nameOf(tally.info.camera.projection);
  for (const Contender& contender : contenders()) {
    const TimedSky timed = timedSky(plan, tally, contender.method);
    const Comparison error = compare(timed.sky.image, reference);
    trials.push_back({&contender, tally.info.rayCount(), timed.timing, error});
    csv.row(scene.name, projection, tally.info.rayCount(), tally.info.seed, contender.methodName(), contender.settings,
            timed.timing.seconds, timed.timing.cpuSeconds, error.relMse, error.relMseError, error.mse, error.logMse,
            error.ssim, error.energyError);
  }
}

}  // namespace

void measureAccuracy(const Plan& plan) {
  Csv csv(plan.results / "recon_accuracy.csv", comment(plan),
          "scene,projection,rays,seed,method,settings,seconds,cpu_seconds,relMSE,relMSE_error,MSE,logMSE,SSIM,"
          "energy_error");
  std::vector<Summary> summaries;
  for (const BenchScene& scene : benchScenes(plan)) {
    const Tally reference = referenceTally(plan, scene);
    std::vector<Trial> trials;
    for (const std::uint64_t rays : plan.rayCounts()) {
      for (int seed = 1; seed <= plan.repeats(rays); ++seed) {
        const Tally tally = sceneTally(plan, scene, rays, static_cast<std::uint64_t>(seed));
        std::fprintf(stderr, "accuracy: %s, %llu rays, seed %d\n", scene.name.c_str(),
                     static_cast<unsigned long long>(rays), seed);
        tryAll(plan, scene, tally, reference, trials, csv);
      }
    }
    const std::vector<Summary> own = summarise(scene.name, trials, plan.rayCounts(), tracingSpeed(plan, scene));
    summaries.insert(summaries.end(), own.begin(), own.end());
  }
  writeSummaries(plan, summaries);
}

}  // namespace parhelion::bench
