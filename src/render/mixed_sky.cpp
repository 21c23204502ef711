// SPDX-License-Identifier: Apache-2.0
#include "render/mixed_sky.h"

#include <algorithm>
#include <cmath>

#include "parallel/run_clock.h"
#include "parallel/threads.h"
#include "picture/image.h"
#include "render/light_parts.h"
#include "render/measurements.h"
#include "render/sky_files.h"
#include "render/traced_sky.h"
#include "sky/camera.h"
#include "sky/radiance.h"
#include "trace/sky_map.h"

namespace parhelion {

namespace {

/// By population.
std::vector<bool> integrable(const Scene& scene) {
  std::vector<bool> result;
  for (const std::string& objection : objectionsToIntegrating(scene)) result.push_back(objection.empty());
  return result;
}

/// The scene with those of its populations alone that are integrable, or that are not.
LoadedScene onlyWith(const LoadedScene& loaded, const std::vector<bool>& isIntegrable, bool wanted) {
  LoadedScene part = loaded;
  part.scene.populations.clear();
  for (std::size_t k = 0; k < isIntegrable.size(); ++k)
    if (isIntegrable[k] == wanted) part.scene.populations.push_back(loaded.scene.populations[k]);
  part.scene.trace.engine = Engine::automatic;
  return part;
}

bool hasLight(const LoadedScene& loaded) {
  return std::ranges::any_of(loaded.scene.populations, [](const auto& one) { return one.weight > 0.0; });
}

/// The share of a scene's light that meets populations which are not integrable.
double tracedShareOf(const Scene& scene, const std::vector<bool>& isIntegrable) {
  const Cloud all = cloudByLight(scene);
  double traced = 0.0;
  for (std::size_t k = 0; k < isIntegrable.size(); ++k)
    if (!isIntegrable[k]) traced += all.lightShares()[k];
  return traced;
}

/// Names of the populations by how their light is made.
MixedSky namesOf(const Scene& scene, const std::vector<bool>& isIntegrable) {
  MixedSky mixed;
  for (std::size_t k = 0; k < isIntegrable.size(); ++k)
    (isIntegrable[k] ? mixed.integrated : mixed.traced).push_back(scene.populations[k].name);
  return mixed;
}

/// Adds up the pixels of a map's picture, and what goes straight on.
void addPixels(LightMap& map, const IntegratedSky& sky, const Scene& scene) {
  const Camera camera(scene.camera);
  const auto &radiance = *sky.image.find("G"), &variance = *sky.image.find(kVarianceChannel);
  for (int y = 0; y < camera.height(); ++y)
    for (int x = 0; x < camera.width(); ++x) {
      const auto pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(camera.width()) + static_cast<std::size_t>(x);
      const auto bin = static_cast<std::size_t>(map.grid.binAt(*camera.directionAt({x + 0.5, y + 0.5})));
      const double solidAngle = camera.solidAngle(x, y);
      map.energy[bin] += solidAngle * static_cast<double>(radiance[pixel]);
      map.error[bin] += solidAngle * std::sqrt(static_cast<double>(variance[pixel]));
    }
  map.energy[static_cast<std::size_t>(map.grid.binAt(Sun(scene.sun).toCentre()))] += sky.info.undeviatedFraction();
}

/// a * image + b * other, channel by channel; squared factors for variances. Channels that one lacks are dark there.
void mix(Image& image, float a, const Image& other, float b) {
  for (Channel& channel : image.channels) {
    const bool isVariance = channel.name == kVarianceChannel;
    const float own = isVariance ? a * a : a, theirs = isVariance ? b * b : b;
    const std::vector<float>* const from = other.find(channel.name);
    for (std::size_t i = 0; i < channel.samples.size(); ++i)
      channel.samples[i] = own * channel.samples[i] + (from ? theirs * (*from)[i] : 0.0F);
  }
}

}  // namespace

std::uint64_t raysOf(const Scene& scene) {
  if (scene.trace.engine == Engine::integral) return 0;
  if (scene.trace.engine != Engine::mixed) return scene.trace.rays;
  const std::vector<bool> isIntegrable = integrable(scene);
  for (std::size_t k = 0; k < isIntegrable.size(); ++k)
    if (scene.populations[k].weight > 0.0 && !isIntegrable[k]) return scene.trace.rays;
  return 0;
}

MixedSky mixSky(const LoadedScene& loaded, double error, const TraceControl& control, LightStore* store) {
  const std::vector<bool> isIntegrable = integrable(loaded.scene);
  const LoadedScene smooth = onlyWith(loaded, isIntegrable, true), rough = onlyWith(loaded, isIntegrable, false);
  MixedSky mixed = namesOf(loaded.scene, isIntegrable);
  if (hasLight(smooth)) {
    const RunClock clock;
    mixed.sky = withThreads(control.threads, [&] { return integrateSky(smooth, error, store); });
    mixed.secondsIntegrated = clock.seconds();
  }
  if (!hasLight(rough)) return mixed;
  const RunClock clock;
  const double traced = tracedShareOf(loaded.scene, isIntegrable);
  const TracedSky rays = traceSky(rough, cloudOf(rough.scene), control);
  mixed.report = rays.report;
  if (rays.report.interrupted) return mixed;
  ReconstructedSky sky = developSky(rays, rough, control.threads);
  mixed.secondsTraced = clock.seconds();
  mixed.tracedShare = traced;
  if (!hasLight(smooth)) {
    mixed.sky.image = std::move(sky.image);
    mixed.sky.info = rays.tally.info();
    return mixed;
  }
  mix(mixed.sky.image, static_cast<float>(1.0 - traced), sky.image, static_cast<float>(traced));
  TallyInfo& info = mixed.sky.info;
  const TallyInfo& ofRays = rays.tally.info();
  const double undeviated = (1.0 - traced) * info.undeviatedFraction() + traced * ofRays.undeviatedFraction();
  info.rays = ofRays.rays;
  info.intercepted = {};
  info.intercepted.add(1.0);
  info.undeviated = {};
  info.undeviated.add(undeviated);
  mixed.sky.cutOff *= 1.0 - traced;
  return mixed;
}

int pixelsPerBin(int binsPerHalfTurn) {
  constexpr int kFewestPerHalfTurn = 180;  // wider ones take longer than more of them
  return 2 * std::max(1, (kFewestPerHalfTurn / 2 + binsPerHalfTurn - 1) / binsPerHalfTurn);
}

LoadedScene sceneOfMap(const LoadedScene& loaded, int binsPerHalfTurn) {
  LoadedScene whole = loaded;
  whole.scene.trace.paths.layers.clear();
  CameraSettings& camera = whole.scene.camera;
  camera = {};
  camera.projection = Projection::equirectangular;
  camera.elevation = 0.0;
  camera.fieldOfView = 2.0 * kPi;
  camera.height = binsPerHalfTurn * pixelsPerBin(binsPerHalfTurn);
  camera.width = 2 * camera.height;
  return whole;
}

MixedMap mixMap(const LoadedScene& loaded, int binsPerHalfTurn, double error, const TraceControl& control) {
  const LoadedScene whole = sceneOfMap(loaded, binsPerHalfTurn);
  const std::vector<bool> isIntegrable = integrable(whole.scene);
  const LoadedScene smooth = onlyWith(whole, isIntegrable, true), rough = onlyWith(whole, isIntegrable, false);
  MixedMap map{LightMap(MapGrid(binsPerHalfTurn)), namesOf(whole.scene, isIntegrable)};
  MixedSky& made = map.made;
  if (hasLight(smooth)) {
    const RunClock clock;
    made.sky = withThreads(control.threads, [&] { return integrateSky(smooth, error, nullptr, Counted::energy); });
    addPixels(map.light, made.sky, smooth.scene);
    made.sky.image = {};
    made.secondsIntegrated = clock.seconds();
  }
  if (!hasLight(rough)) return map;
  const RunClock clock;
  const Cloud cloud = cloudByLight(rough.scene);
  SkyMap rays(cloud.sun().toCentre(), binsPerHalfTurn);
  made.report = traceRays(cloud, settingsOfMeasurement(cloud, rough.scene.trace), 0, rays, control);
  made.secondsTraced = clock.seconds();
  const double traced = made.tracedShare = tracedShareOf(whole.scene, isIntegrable);
  const LightMap ofRays = rays.light();
  for (std::size_t bin = 0; bin < ofRays.energy.size(); ++bin) {
    map.light.energy[bin] = (1.0 - traced) * map.light.energy[bin] + traced * ofRays.energy[bin];
    map.light.error[bin] = std::hypot((1.0 - traced) * map.light.error[bin], traced * ofRays.error[bin]);
  }
  made.sky.info.rays = {{0, made.report.rays}};
  made.sky.cutOff *= 1.0 - traced;
  return map;
}

}  // namespace parhelion
