// SPDX-License-Identifier: Apache-2.0
#include "recon_scenes.h"

#include <array>
#include <cstdio>
#include <optional>

#include "image/tally_exr.h"
#include "trace/sky_film.h"
#include "trace/trace.h"

namespace parhelion::bench {
namespace {

constexpr std::uint64_t kReferenceSeed = 1000;
constexpr std::uint64_t kQuickReferenceRays = 10'000'000;

const std::string kMixed = "scenes/reconstruction-reference.toml";

struct Traced {
  Tally tally;
  double seconds;
};

Traced trace(const LoadedScene& loaded) {
  const Scene& scene = loaded.scene;
  const Cloud cloud(scene.sun, scene.ice, scene.populations);
  TallyInfo info;
  info.seed = scene.trace.seed;
  info.white = cloud.spectrum().white();
  info.sunElevation = scene.sun.elevation;
  info.sunDiameter = scene.sun.diameter;
  info.camera = scene.camera;
  info.scene = loaded.text;
  info.version = PARHELION_VERSION;
  Tally tally(info, cloud.spectrum().colours());
  SkyFilm film(tally);
  const TraceReport report = traceRays(cloud, scene.trace, 0, film);
  tally.info.rays = {{report.firstRay, report.rays}};
  return {std::move(tally), report.seconds};
}

/// The tally on disk, unless it is of another scene.
std::optional<Tally> kept(const std::filesystem::path& path, const LoadedScene& loaded) {
  if (!std::filesystem::exists(path)) return std::nullopt;
  Tally tally = readTallyExr(path);
  if (tally.info.scene != loaded.text || tally.info.version != PARHELION_VERSION) return std::nullopt;
  return tally;
}

}  // namespace

LoadedScene BenchScene::load(const Plan& plan, std::uint64_t rays, std::uint64_t seed) const {
  std::vector<std::string> all{"sun.spectrum=550.0", "trace.path='chance'", "camera.resolution=[512, 512]",
                               "trace.rays=" + std::to_string(rays), "trace.seed=" + std::to_string(seed)};
  all.insert(all.end(), overrides.begin(), overrides.end());
  return loadScene(plan.source / file, all);
}

std::span<const BenchScene> benchScenes(const Plan& plan) {
  static const std::array<BenchScene, 4> scenes{{
      {"mixed", kMixed, {}, 330'000'000},
      // A tenth of the sky: few rays land in view.
      {"photograph",
       kMixed,
       {"camera.projection='rectilinear'", "camera.azimuth=0", "camera.elevation=25", "camera.fov_horizontal=60"},
       200'000'000},
      {"pyramids", "bench/scenes/columns-and-pyramids.toml", {}, 100'000'000},
      {"display", "scenes/display.toml", {}, 100'000'000},
  }};
  return std::span(scenes).first(plan.quick ? 2 : scenes.size());
}

Tally sceneTally(const Plan& plan, const BenchScene& scene, std::uint64_t rays, std::uint64_t seed) {
  const LoadedScene loaded = scene.load(plan, rays, seed);
  const std::filesystem::path path =
      plan.tallies / (scene.name + "-" + std::to_string(rays) + "-" + std::to_string(seed) + ".exr");
  if (std::optional<Tally> tally = kept(path, loaded)) return std::move(*tally);
  std::fprintf(stderr, "tracing %llu rays of %s\n", static_cast<unsigned long long>(rays), scene.name.c_str());
  Tally tally = trace(loaded).tally;
  writeTallyExr(path, tally);
  return tally;
}

std::uint64_t referenceRays(const Plan& plan, const BenchScene& scene) {
  return plan.quick ? kQuickReferenceRays : scene.referenceRays;
}

Tally referenceTally(const Plan& plan, const BenchScene& scene) {
  return sceneTally(plan, scene, referenceRays(plan, scene), kReferenceSeed);
}

double tracingSpeed(const Plan& plan, const BenchScene& scene) {
  const std::uint64_t rays = plan.quick ? 300'000 : 3'000'000;
  return static_cast<double>(rays) / trace(scene.load(plan, rays, 1)).seconds;
}

}  // namespace parhelion::bench
