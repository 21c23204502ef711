// SPDX-License-Identifier: Apache-2.0
#include "render/more_orders.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "crystal/symmetry.h"
#include "math/portable.h"
#include "parallel/loops.h"
#include "parallel/threads.h"
#include "render/air_background.h"
#include "render/crystal_sides.h"
#include "render/traced_sky.h"
#include "sky/radiance.h"
#include "trace/flight_places.h"
#include "trace/sky_film.h"

namespace parhelion {

namespace {

/// Of light that has been through several crystals: the sun's vertical is all that is left.
TallySymmetry symmetryOf(const Scene& scene) {
  const bool isMirrored = std::ranges::all_of(scene.populations, [](const PopulationSettings& population) {
    return isFullyRandom(population) || isMirrorSymmetric(population);
  });
  return isMirrored && scene.trace.symmetry != Symmetry::none ? TallySymmetry::mirror : TallySymmetry::none;
}

/// The layer of light that was scattered so often: the first one that asks for no path through one crystal, nor for
/// another order. The rest comes last.
int layerOf(const std::vector<LayerSettings>& layers, int order) {
  const auto takes = [order](const LayerSettings& layer) { return layer.takesOrder(order); };
  return static_cast<int>(std::ranges::find_if(layers, takes) - layers.begin());
}

SkyTally emptyTally(const LoadedScene& loaded, const Spectrum& spectrum) {
  std::vector<std::string> layers;
  for (const LayerSettings& layer : loaded.scene.trace.paths.layers) layers.push_back(layer.name);
  return SkyTally(skyInfoOf(loaded), spectrum.colours(), {symmetryOf(loaded.scene)}, layers);
}

/// The size of what is deposited of light that was scattered once, which is stored in units of it: about what twice a
/// slab's depth scatters. Never so little that light along the horizon, which a slab of any depth scatters, would not
/// fit.
double secondShare(double opticalDepth) {
  constexpr double kLeast = 0.05;
  return std::max(kLeast, takenOver(2.0 * opticalDepth));
}

std::vector<Tally*> talliesOf(SkyTally& sky) {
  std::vector<Tally*> all;
  for (SkyTally::Part& part : sky.parts()) all.push_back(&part.tally);
  return all;
}

/// All but the noise of a picture times a factor, and that times its square.
void scale(Image& image, double factor) {
  for (Channel& channel : image.channels) {
    const double own = channel.name == kVarianceChannel ? factor * factor : factor;
    for (float& sample : channel.samples) sample = static_cast<float>(own * static_cast<double>(sample));
  }
}

bool isOfErrors(const std::string& name) { return name == kVarianceChannel || name == kBiasChannel; }

}  // namespace

std::optional<MoreOrders> moreOrders(const LoadedScene& loaded, std::uint64_t rays, const SlabLight& slab,
                                     const LayerGains& gains, int threads, const WalkWatch& watch) {
  const Scene& scene = loaded.scene;
  const SunSettings sun = sunAtCloud(scene);
  const double rise = Sun(sun).toCentre().z;
  if (!scene.cloud || scene.cloud->orders < 2 || !(rise > 0.0)) return std::nullopt;
  const Engine engine = isTraced(scene.trace.engine) ? scene.trace.engine : Engine::automatic;
  const ManyOrders orders({sun, scene.ice, scene.populations, scene.hazes}, scene.cloud->orders, slab.stack(), engine);
  SkyTally tally = emptyTally(loaded, orders.spectrum());
  const auto& layers = scene.trace.paths.layers;
  OrderDeposits deposits;
  deposits.scale = 1.0 / (orders.scattered() * secondShare(scene.cloud->opticalDepth));
  const CrystalSides sides = crystalSides(scene);
  deposits.fromBelow = sides.above;
  deposits.fromAbove = sides.below;
  if (!layers.empty()) deposits.layerOf = [&](int order) { return layerOf(layers, order); };
  SkyFilm film(talliesOf(tally), tally.shared().empty() ? nullptr : &tally.shared().front());
  TraceControl control;
  control.threads = threads;
  if (watch.stop && !*watch.stop) control.stop = watch.stop;
  const std::uint64_t walks = std::max<std::uint64_t>(1, (rays > 0 ? rays : scene.trace.rays) / kRaysPerWalk);
  if (watch.onProgress)
    control.onProgress = [&](std::uint64_t done, double seconds) {
      watch.onProgress(static_cast<double>(done) / static_cast<double>(walks), seconds);
    };
  MoreOrders more{{}, traceOrders(orders, walks, scene.trace, deposits, film, control)};
  for (Tally* one : talliesOf(tally)) more.report.light.addTo(one->info);
  for (SkyTally::Shared& shared : tally.shared()) more.report.light.addTo(shared.info);
  tally.info().rays = {{0, more.report.walks}};
  tally.shareOrigin();
  more.image = withThreads(threads, [&] { return reconstruct(tally, scene.recon, gains); }).image;
  scale(more.image, slab.illuminance() * rise / deposits.scale);
  return more;
}

void addHaze(Image& image, const Camera& camera, const Scene& scene, double ofHaze) {
  if (!(ofHaze > 0.0)) return;
  scale(image, 1.0 - ofHaze);
  double weight = 0.0;
  std::vector<PhaseFunction> phases;
  for (const HazeSettings& haze : scene.hazes) {
    phases.emplace_back(haze.phase);
    weight += haze.weight;
  }
  const Vec3 toSun = Sun(scene.sun).toCentre();
  const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  std::vector<float> light(pixels);
  forRows(image.height, [&](int y) {
    for (int x = 0; x < image.width; ++x) {
      const auto toSky = camera.toSky({x + 0.5, y + 0.5});
      if (!toSky) continue;
      const double cosine = toSky->x * toSun.x + toSky->y * toSun.y + toSky->z * toSun.z;
      double sum = 0.0;
      for (std::size_t k = 0; k < phases.size(); ++k) sum += scene.hazes[k].weight * phases[k].at(cosine);
      light[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x)] =
          static_cast<float>(ofHaze / weight * sum);
    }
  });
  const std::string rest = std::string(kRestLayer) + ".";
  for (Channel& channel : image.channels) {
    const bool isWhole = channel.name.find('.') == std::string::npos;
    if (isOfErrors(channel.name) || (!isWhole && !channel.name.starts_with(rest))) continue;
    for (std::size_t i = 0; i < pixels; ++i) channel.samples[i] += light[i];
  }
}

}  // namespace parhelion
