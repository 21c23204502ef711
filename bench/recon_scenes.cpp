// SPDX-License-Identifier: Apache-2.0
#include "recon_scenes.h"

#include <array>

#include "traced_tally.h"

namespace parhelion::bench {
namespace {

constexpr std::uint64_t kReferenceSeed = 1000;
constexpr std::uint64_t kQuickReferenceRays = 10'000'000;

const std::string kMixed = "scenes/reconstruction-reference.toml";

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
  return keptTally(path, loaded);
}

std::uint64_t referenceRays(const Plan& plan, const BenchScene& scene) {
  return plan.quick ? kQuickReferenceRays : scene.referenceRays;
}

Tally referenceTally(const Plan& plan, const BenchScene& scene) {
  return sceneTally(plan, scene, referenceRays(plan, scene), kReferenceSeed);
}

double tracingSpeed(const Plan& plan, const BenchScene& scene) {
  const std::uint64_t rays = plan.quick ? 300'000 : 3'000'000;
  return static_cast<double>(rays) / tracePlainly(scene.load(plan, rays, 1)).report.seconds;
}

}  // namespace parhelion::bench
