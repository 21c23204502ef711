// SPDX-License-Identifier: Apache-2.0
#include "render/mixed_sky.h"

#include <algorithm>
#include <cmath>

#include "parallel/run_clock.h"
#include "parallel/threads.h"
#include "picture/image.h"
#include "render/development.h"
#include "render/light_parts.h"
#include "render/measurements.h"
#include "render/tracing_run.h"
#include "sky/camera.h"
#include "sky/picture_error.h"
#include "sky/radiance.h"
#include "trace/sky_map.h"
#include "trace/tracer.h"

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

/// Whether a scene has light of populations that are integrable, or that are not.
bool hasLight(const Scene& scene, const std::vector<bool>& isIntegrable, bool wanted) {
  for (std::size_t k = 0; k < isIntegrable.size(); ++k)
    if (scene.populations[k].weight > 0.0 && isIntegrable[k] == wanted) return true;
  return false;
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

/// What is known of a picture beside its rays: the share of all light that is left to them; of the other light, how
/// much of it the picture shows and its error.
struct OtherLight {
  double share, light, error;
};

/// The picture of the populations that rays are followed for.
struct RestSky {
  RunReport report;
  Image image;
  TallyInfo info;
  double error = 0.0;  // of the whole picture, in which errors of both parts may go together
};

RestSky traceRest(const LoadedScene& loaded, const OtherLight& other, const MixGoal& goal,
                  const TraceControl& control) {
  const Cloud cloud = cloudOf(loaded.scene);
  const TraceSettings settings = chosenSettings(cloud, loaded.scene.trace);
  SkySums sums(loaded, cloud);
  Development picture(sums, loaded, control.threads);
  const auto measure = [&]() -> std::optional<double> {
    const std::optional<double> own = picture.error(control.stop);
    if (!own) return own;
    const double light = other.share * pictureLight(picture.image(), loaded.scene.camera);
    return (*own * light + other.error * other.light) / (light + other.light);
  };
  RunControl run;
  static_cast<TraceControl&>(run) = control;
  if (goal.raysEndEarly) run.goal = {goal.error, measure};
  Tracer tracer(cloud, settings, sums.film(), control.threads, control.simd);
  RestSky rest;
  rest.report = traceRun(tracer, sums.film(), sums.origin().rays, {{0, settings.rays}}, cloud.bundleSize(), run);
  if (rest.report.interrupted) return rest;
  const std::optional<double> error = rest.report.error ? rest.report.error : measure();
  rest.report.interrupted = !error;
  if (!error) return rest;
  rest.error = *error;
  rest.image = picture.take().image;
  rest.info = sums.tally().info();
  return rest;
}

}  // namespace

std::uint64_t raysOf(const Scene& scene) {
  if (scene.trace.engine == Engine::integral) return 0;
  if (scene.trace.engine != Engine::mixed) return scene.trace.rays;
  return hasLight(scene, integrable(scene), false) ? scene.trace.rays : 0;
}

Engine integratingEngine(const Scene& scene) {
  if (scene.trace.engine != Engine::automatic) return scene.trace.engine;
  const std::vector<bool> isIntegrable = integrable(scene);
  if (!hasLight(scene, isIntegrable, true)) return Engine::automatic;
  return hasLight(scene, isIntegrable, false) ? Engine::mixed : Engine::integral;
}

std::optional<LoadedScene> onlyTraced(const LoadedScene& loaded) {
  const std::vector<bool> isIntegrable = integrable(loaded.scene);
  if (!hasLight(loaded.scene, isIntegrable, false)) return {};
  return onlyWith(loaded, isIntegrable, false);
}

double tracedShareOf(const Scene& scene) {
  const std::vector<bool> isIntegrable = integrable(scene);
  const Cloud all = cloudByLight(scene);
  double traced = 0.0;
  for (std::size_t k = 0; k < isIntegrable.size(); ++k)
    if (!isIntegrable[k]) traced += all.lightShares()[k];
  return traced;
}

MixedSky mixSky(const LoadedScene& loaded, const MixGoal& goal, const TraceControl& control, LightStore* store) {
  const std::vector<bool> isIntegrable = integrable(loaded.scene);
  const LoadedScene smooth = onlyWith(loaded, isIntegrable, true), rough = onlyWith(loaded, isIntegrable, false);
  const bool hasSmooth = hasLight(loaded.scene, isIntegrable, true),
             hasRough = hasLight(loaded.scene, isIntegrable, false);
  MixedSky mixed = namesOf(loaded.scene, isIntegrable);
  if (hasSmooth) {
    const RunClock clock;
    mixed.sky = withThreads(control.threads,
                            [&] { return integrateSky(smooth, goal.error, store, Counted::colour, goal.goOn); });
    mixed.secondsIntegrated = clock.seconds();
  }
  if (!hasRough || mixed.sky.refused) return mixed;
  const RunClock clock;
  const double traced = mixed.tracedShare = tracedShareOf(loaded.scene), rest = hasSmooth ? 1.0 - traced : 0.0;
  const double smoothLight = rest > 0.0 ? rest * pictureLight(mixed.sky.image, loaded.scene.camera) : 0.0;
  RestSky others = traceRest(rough, {traced, smoothLight, mixed.sky.error}, goal, control);
  mixed.report = others.report;
  if (others.report.interrupted) return mixed;
  mixed.secondsTraced = clock.seconds();
  mixed.sky.error = others.error;
  if (goal.raysEndEarly) mixed.sky.reached = others.error <= goal.error;
  if (!hasSmooth) {
    mixed.sky.image = std::move(others.image);
    mixed.sky.info = others.info;
    return mixed;
  }
  mix(mixed.sky.image, static_cast<float>(rest), others.image, static_cast<float>(traced));
  TallyInfo& info = mixed.sky.info;
  const double undeviated = rest * info.undeviatedFraction() + traced * others.info.undeviatedFraction();
  info.rays = others.info.rays;
  info.intercepted = {};
  info.intercepted.add(1.0);
  info.undeviated = {};
  info.undeviated.add(undeviated);
  mixed.sky.cutOff *= rest;
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
  const bool hasSmooth = hasLight(whole.scene, isIntegrable, true),
             hasRough = hasLight(whole.scene, isIntegrable, false);
  MixedMap map{LightMap(MapGrid(binsPerHalfTurn)), namesOf(whole.scene, isIntegrable)};
  MixedSky& made = map.made;
  if (hasSmooth) {
    const RunClock clock;
    made.sky = withThreads(control.threads, [&] { return integrateSky(smooth, error, nullptr, Counted::energy); });
    addPixels(map.light, made.sky, smooth.scene);
    made.sky.image = {};
    made.secondsIntegrated = clock.seconds();
  }
  if (!hasRough) return map;
  const RunClock clock;
  const Cloud cloud = cloudByLight(rough.scene);
  SkyMap rays(cloud.sun().toCentre(), binsPerHalfTurn);
  made.report = traceRays(cloud, settingsOfMeasurement(cloud, rough.scene.trace), 0, rays, control);
  made.secondsTraced = clock.seconds();
  const double traced = made.tracedShare = tracedShareOf(whole.scene);
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
