// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "csv.h"
#include "parallel/threads.h"
#include "picture/exr.h"
#include "rays_plan.h"
#include "recon/compare.h"
#include "recon/reconstruct.h"
#include "render/mixed_sky.h"
#include "render/traced_sky.h"
#include "sky/radiance.h"
#include "stopwatch.h"
#include "traced_tally.h"

namespace parhelion::bench {
namespace {

struct Display {
  std::string_view id, scene;
  std::vector<std::string> changes;  // of the scene
};

const std::array<Display, 5> kDisplays{{{"random columns", "random-columns", {}},
                                        {"columns at rest", "circumscribed", {"population.columns.tilt=0.0"}},
                                        {"plates", "parhelia", {}},
                                        {"Parry", "parry", {}},
                                        {"display", "display", {}}}};

struct Curve {
  std::string_view id;
  bool adaptive;
  std::vector<std::string> changes;
};

const std::array<Curve, 4> kCurves{{{"plain rays", false, {"trace.symmetry='none'"}},
                                    {"Sobol' points", false, {"trace.symmetry='none'", "trace.sampler='sobol'"}},
                                    {"mirrored or in rings", false, {"trace.symmetry='auto'"}},
                                    {"adaptive", true, {"trace.symmetry='auto'"}}}};

constexpr double kErrors[] = {0.1, 0.04, 0.02};

LoadedScene load(const RaysPlan& plan, const Display& display, std::uint64_t rays, std::uint64_t seed,
                 const std::vector<std::string>& changes) {
  std::vector<std::string> overrides{"camera.resolution=[512, 512]", "sun.visible=false",
                                     "trace.rays=" + std::to_string(rays), "trace.seed=" + std::to_string(seed)};
  overrides.insert(overrides.end(), display.changes.begin(), display.changes.end());
  overrides.insert(overrides.end(), changes.begin(), changes.end());
  return loadScene(plan.source / "scenes" / (std::string(display.scene) + ".toml"), overrides);
}

std::uint64_t referenceRays(const RaysPlan& plan) { return plan.quick ? 3'000'000 : 100'000'000; }

}  // namespace

void measureIntegral(const RaysPlan& plan) {
  Csv csv(plan.results / "rays_integral.csv",
          "Colours and the sun's disc, 512 x 512 pixels, seed 1, one thread; references of " +
              std::to_string(referenceRays(plan)) +
              " rays.\ncpu_seconds: of the whole picture, from the scene to its pixels. relMSE: in all pixels.",
          "scene,curve,rays,error_goal,cpu_seconds,relMSE,relMSE_error");
  const double most = plan.quick ? 0.3 : 5.0;  // CPU seconds of one point
  for (const Display& display : kDisplays) {
    std::string name = "integral-" + std::string(display.id) + "-" + std::to_string(referenceRays(plan)) + ".exr";
    for (char& letter : name)
      if (letter == ' ') letter = '-';
    const Tally truth =
        keptTally(plan.tallies / name, load(plan, display, referenceRays(plan), 1000, {"trace.symmetry='none'"}));
    for (const Curve& curve : kCurves) {
      double last = 0.0;
      for (double rays = 3e4; last * std::sqrt(10.0) < most; rays *= std::sqrt(10.0)) {
        const LoadedScene loaded =
            load(plan, display, static_cast<std::uint64_t>(std::llround(rays)), 1, curve.changes);
        const Stopwatch watch;
        TraceControl control;
        control.threads = 1;
        const TracedSky traced = traceSky(loaded, cloudOf(loaded.scene), control);
        const Image picture = withThreads(1, [&] {
          return curve.adaptive ? reconstruct(traced.tally, AdaptiveSettings{}).image
                                : plainRadiance(traced.tally.flattened());
        });
        last = watch.read().cpuSeconds;
        const Comparison off = compare(picture, truth);
        csv.row(display.id, curve.id, loaded.scene.trace.rays, 0.0, last, off.relMse, off.relMseError);
      }
    }
    for (const double error : kErrors) {
      if (plan.quick && error < 0.1) break;
      const LoadedScene loaded =
          load(plan, display, 10'000'000, 1, {"trace.symmetry='auto'", "recon.method='adaptive'"});
      TraceControl control;
      control.threads = 1;
      const Stopwatch watch;
      const MixedSky sky = mixSky(loaded, {error}, control);
      const double seconds = watch.read().cpuSeconds;
      const Comparison off = compare(sky.sky.image, truth);
      csv.row(display.id, sky.traced.empty() ? "integral" : "mixed", sky.sky.info.rayCount(), error, seconds,
              off.relMse, off.relMseError);
    }
  }
}

}  // namespace parhelion::bench
