// SPDX-License-Identifier: Apache-2.0
#include "render/mixed_sky.h"

#include <algorithm>

#include "parallel/run_clock.h"
#include "parallel/threads.h"
#include "picture/image.h"
#include "render/light_parts.h"
#include "render/sky_files.h"
#include "render/traced_sky.h"
#include "sky/radiance.h"

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
  MixedSky mixed;
  for (std::size_t k = 0; k < isIntegrable.size(); ++k)
    (isIntegrable[k] ? mixed.integrated : mixed.traced).push_back(loaded.scene.populations[k].name);
  if (hasLight(smooth)) {
    const RunClock clock;
    mixed.sky = withThreads(control.threads, [&] { return integrateSky(smooth, error, store); });
    mixed.secondsIntegrated = clock.seconds();
  }
  if (!hasLight(rough)) return mixed;
  const RunClock clock;
  const Cloud all = cloudByLight(loaded.scene);
  double traced = 0.0;
  for (std::size_t k = 0; k < loaded.scene.populations.size(); ++k)
    if (!isIntegrable[k]) traced += all.lightShares()[k];
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

}  // namespace parhelion
