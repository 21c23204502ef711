// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "csv.h"
#include "parallel/threads.h"
#include "picture/exr.h"
#include "rays_plan.h"
#include "recon/compare.h"
#include "recon/reconstruct.h"
#include "render/integrated_profile.h"
#include "render/measurements.h"
#include "render/mixed_sky.h"
#include "render/traced_sky.h"
#include "sky/radiance.h"
#include "stopwatch.h"
#include "trace/scatter_profile.h"
#include "traced_tally.h"

namespace parhelion::bench {
namespace {

struct Display {
  std::string_view id, scene;
  std::vector<std::string> changes;  // of the scene
};

const std::array<Display, 6> kDisplays{{{"random columns", "random-columns", {}},
                                        {"columns at rest", "circumscribed", {"population.columns.tilt=0.0"}},
                                        {"plates", "sun-pillar", {}},
                                        {"Parry", "parry", {}},
                                        {"parhelia", "parhelia", {}},
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

constexpr double kErrors[] = {0.3, 0.1, 0.05, 0.02, 0.01};
constexpr double kProfileErrors[] = {0.03, 0.01, 0.003, 0.001};
constexpr int kProfileBins = 1800;

LoadedScene load(const RaysPlan& plan, const Display& display, std::uint64_t rays, std::uint64_t seed,
                 const std::vector<std::string>& changes) {
  std::vector<std::string> overrides{"camera.resolution=[512, 512]", "sun.visible=false",
                                     "trace.rays=" + std::to_string(rays), "trace.seed=" + std::to_string(seed)};
  overrides.insert(overrides.end(), display.changes.begin(), display.changes.end());
  overrides.insert(overrides.end(), changes.begin(), changes.end());
  return loadScene(plan.source / "scenes" / (std::string(display.scene) + ".toml"), overrides);
}

std::uint64_t referenceRays(const RaysPlan& plan) { return plan.quick ? 3'000'000 : 100'000'000; }

// Integrals get better until one has taken longer than so many points of rays.
constexpr double kLongest = 4.0;

/// Points of one curve go on until the next is likely to take longer than this, in CPU seconds.
double most(const RaysPlan& plan) { return plan.quick ? 0.3 : 4.0; }

TraceControl oneThread() {
  TraceControl control;
  control.threads = 1;
  return control;
}

/// Calls point(rays), which returns CPU seconds, for ever more rays.
template <class Point>
void forMoreRays(const RaysPlan& plan, const Point& point) {
  const double step = std::sqrt(10.0);
  double last = 0.0;
  for (double rays = 3e4; last * step < most(plan); rays *= step)
    last = point(static_cast<std::uint64_t>(std::llround(rays)));
}

void measureSky(const RaysPlan& plan, const Display& display, Csv& csv) {
  std::string name = "integral-" + std::string(display.id) + "-" + std::to_string(referenceRays(plan)) + ".exr";
  std::ranges::replace(name, ' ', '-');
  const Tally truth =
      keptTally(plan.tallies / name, load(plan, display, referenceRays(plan), 1000, {"trace.symmetry='none'"}));
  for (const Curve& curve : kCurves)
    forMoreRays(plan, [&](std::uint64_t rays) {
      const LoadedScene loaded = load(plan, display, rays, 1, curve.changes);
      const Stopwatch watch;
      const TracedSky traced = traceSky(loaded, cloudOf(loaded.scene), oneThread());
      const Image picture = withThreads(1, [&] {
        return curve.adaptive ? reconstruct(traced.tally, AdaptiveSettings{}).image
                              : plainRadiance(traced.tally.flattened());
      });
      const double seconds = watch.read().cpuSeconds;
      const Comparison off = compare(picture, truth);
      csv.row(display.id, curve.id, rays, 0.0, seconds, off.relMse, off.relMseError);
      return seconds;
    });
  for (const double error : kErrors) {
    if (plan.quick && error < 0.3) break;
    const LoadedScene loaded =
        load(plan, display, 100'000'000, 1, {"trace.symmetry='auto'", "recon.method='adaptive'"});
    const Stopwatch watch;
    const MixedSky sky = mixSky(loaded, {error, true, {}}, oneThread());
    const double seconds = watch.read().cpuSeconds;
    const Comparison off = compare(sky.sky.image, truth);
    csv.row(display.id, sky.traced.empty() ? "integral" : "mixed", sky.sky.info.rayCount(), error, seconds, off.relMse,
            off.relMseError);
    if (seconds > kLongest * most(plan)) break;
  }
}

std::vector<ScatterProfile::Bin> tracedProfile(const LoadedScene& loaded, const TraceControl& control) {
  const Cloud cloud = cloudByLight(loaded.scene);
  ScatterProfile profile(kProfileBins, 0.0, kPi);
  traceRays(cloud, settingsOfMeasurement(cloud, loaded.scene.trace), 0, profile, control);
  return profile.bins();
}

/// The mean squared relative error, less what of it is the reference's, in the bins that this knows to 1 %.
Comparison compareProfiles(const std::vector<ScatterProfile::Bin>& bins,
                           const std::vector<ScatterProfile::Bin>& truth) {
  constexpr double kKnown = 0.01;
  double sum = 0.0, squares = 0.0, count = 0.0;
  for (std::size_t k = 0; k < bins.size(); ++k) {
    if (!(truth[k].error <= kKnown * truth[k].energy)) continue;
    const double off = (bins[k].energy - truth[k].energy) / truth[k].energy, own = truth[k].error / truth[k].energy,
                 square = off * off - own * own;
    sum += square;
    squares += square * square;
    count += 1.0;
  }
  Comparison comparison;
  comparison.relMse = sum / count;
  comparison.relMseError = std::sqrt(squares - sum * sum / count) / count;
  return comparison;
}

void measureProfile(const RaysPlan& plan, const Display& display, Csv& csv) {
  const std::string id = std::string(display.id) + " profile";
  const std::vector<ScatterProfile::Bin> truth = tracedProfile(load(plan, display, referenceRays(plan), 1000, {}), {});
  for (const Curve& curve : std::span(kCurves).first(2))
    forMoreRays(plan, [&](std::uint64_t rays) {
      const LoadedScene loaded = load(plan, display, rays, 1, curve.changes);
      const Stopwatch watch;
      const auto bins = tracedProfile(loaded, oneThread());
      const double seconds = watch.read().cpuSeconds;
      const Comparison off = compareProfiles(bins, truth);
      csv.row(id, curve.id, rays, 0.0, seconds, off.relMse, off.relMseError);
      return seconds;
    });
  const LoadedScene loaded = load(plan, display, 1, 1, {});
  for (const double error : kProfileErrors) {
    const Stopwatch watch;
    const IntegratedProfile profile = withThreads(1, [&] {
      return integrateProfile(loaded.scene, {kProfileBins, 0.0, kPi, error, false});
    });
    const double seconds = watch.read().cpuSeconds;
    const Comparison off = compareProfiles(profile.bins, truth);
    csv.row(id, "integral", 0, error, seconds, off.relMse, off.relMseError);
    if (seconds > kLongest * most(plan)) break;
  }
}

}  // namespace

void measureIntegral(const RaysPlan& plan) {
  Csv csv(plan.results / "rays_integral.csv",
          "Colours and the sun's disc, 512 x 512 pixels, seed 1, one thread; references of " +
              std::to_string(referenceRays(plan)) +
              " rays.\ncpu_seconds: of the whole picture, from the scene to its pixels. relMSE: in all pixels; of the "
              "profile in bins of 0.1 degrees\nthat the reference knows to 1 %, less its own.",
          "scene,curve,rays,error_goal,cpu_seconds,relMSE,relMSE_error");
  measureProfile(plan, kDisplays[0], csv);
  for (const Display& display : kDisplays) measureSky(plan, display, csv);
}

}  // namespace parhelion::bench
