// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "csv.h"
#include "rays_coarser.h"
#include "rays_configurations.h"
#include "rays_plan.h"
#include "recon/compare.h"
#include "recon/reconstruct.h"
#include "render/traced_sky.h"
#include "sky/radiance.h"
#include "stopwatch.h"
#include "trace/expose.h"
#include "traced_tally.h"

namespace parhelion::bench {
namespace {

constexpr std::array<std::string_view, 3> kScenes{"random-columns", "parhelia", "display"};
constexpr std::uint64_t kReferenceSeed = 1000;
constexpr int kCoarser = 4;  // 128 x 128 pixels of the plain picture

struct Point {
  std::uint64_t rays;
  double cpuSeconds;
  Comparison plain, adaptive;
};

LoadedScene load(const RaysPlan& plan, std::string_view scene, std::uint64_t rays, std::uint64_t seed) {
  const std::vector<std::string> overrides{"sun.spectrum=550.0",
                                           "camera.resolution=[512, 512]",
                                           "trace.rays=" + std::to_string(rays),
                                           "trace.seed=" + std::to_string(seed),
                                           "trace.sampler='random'",
                                           "trace.symmetry='none'"};
  return loadScene(plan.source / "scenes" / (std::string(scene) + ".toml"), overrides);
}

std::uint64_t referenceRays(const RaysPlan& plan) { return plan.quick ? 3'000'000 : 100'000'000; }

Tally reference(const RaysPlan& plan, std::string_view scene) {
  const std::uint64_t rays = referenceRays(plan);
  const std::string name = "rays-" + std::string(scene) + "-" + std::to_string(rays) + ".exr";
  return keptTally(plan.tallies / name, load(plan, scene, rays, kReferenceSeed));
}

/// A scene and the truth about it.
struct Truth {
  LoadedScene loaded;
  Cloud cloud;
  Tally fine, coarse;
};

Point measure(const Truth& truth, const Configuration& configuration, std::uint64_t rays) {
  TraceSettings settings = configuration.settings;
  settings.rays = rays;
  LoadedScene loaded = truth.loaded;
  loaded.scene.trace.symmetry = settings.symmetry;
  SkyTally tally = emptyTally(loaded, truth.cloud);
  const Stopwatch watch;
  traceTally(tally, truth.cloud, settings, 0, {.threads = 1, .onProgress = {}});
  Point point{rays, watch.read().cpuSeconds, {}, {}};
  point.plain = compare(plainRadiance(coarser(tally.flattened(), kCoarser)), truth.coarse);
  point.adaptive = compare(reconstruct(tally, AdaptiveSettings{}).image, truth.fine);
  return point;
}

/// Whether a cloud has a symmetry.
bool allows(const Cloud& cloud, Symmetry symmetry) {
  const Symmetry most = symmetryOf(cloud, Symmetry::automatic);
  return symmetry == Symmetry::none || symmetry == most || (symmetry == Symmetry::mirror && most == Symmetry::radial);
}

/// One curve: ten thousand rays and on by factors of the root of ten, until one more point would take too long.
std::vector<Point> curve(const RaysPlan& plan, const Truth& truth, const Configuration& configuration) {
  const double most = plan.quick ? 0.1 : 2.0;  // CPU seconds of one point
  measure(truth, configuration, 10'000);       // to warm up
  std::vector<Point> points;
  for (double rays = 1e4; points.empty() || points.back().cpuSeconds * std::sqrt(10.0) < most; rays *= std::sqrt(10.0))
    points.push_back(measure(truth, configuration, static_cast<std::uint64_t>(std::llround(rays))));
  return points;
}

/// Slope of log error over log time by least squares: -1 where the variance falls as one over the rays.
template <class Error>
double slope(const std::vector<Point>& points, Error error) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const Point& point : points) {
    const double e = error(point);
    if (!(e > 0.0)) continue;
    const double logTime = std::log(point.cpuSeconds), logError = std::log(e);
    n += 1.0;
    x += logTime;
    y += logError;
    xx += logTime * logTime;
    xy += logTime * logError;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace

void measureErrorByTime(const RaysPlan& plan) {
  Csv csv(plan.results / "rays_error_by_time.csv",
          "550 nm, 512 x 512 pixels, seed 1, one thread; references of " + std::to_string(referenceRays(plan)) +
              " rays.\nplain: relMSE of the plain picture in 128 x 128 pixels. adaptive: of the reconstruction in all "
              "pixels.\ncpu_seconds: of tracing alone. The slopes are of log relMSE over log cpu_seconds.",
          "scene,configuration,label,rays,cpu_seconds,plain,plain_error,plain_slope,adaptive,adaptive_error,"
          "adaptive_slope");
  for (const std::string_view scene : std::span(kScenes).first(plan.quick ? 2 : 3)) {
    const LoadedScene loaded = load(plan, scene, 1, 1);
    Tally fine = reference(plan, scene);
    Tally coarse = coarser(fine, kCoarser);
    const Truth truth{loaded, cloudOf(loaded.scene), std::move(fine), std::move(coarse)};
    for (const Configuration& configuration : kConfigurations) {
      if (!allows(truth.cloud, configuration.settings.symmetry)) continue;
      const std::vector<Point> points = curve(plan, truth, configuration);
      const double plainSlope = slope(points, [](const Point& p) { return p.plain.relMse; });
      const double adaptiveSlope = slope(points, [](const Point& p) { return p.adaptive.relMse; });
      for (const Point& p : points) {
        csv.row(scene, configuration.id, configuration.label, p.rays, p.cpuSeconds, p.plain.relMse, p.plain.relMseError,
                plainSlope, p.adaptive.relMse, p.adaptive.relMseError, adaptiveSlope);
      }
    }
  }
}

}  // namespace parhelion::bench
