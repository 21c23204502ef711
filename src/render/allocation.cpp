// SPDX-License-Identifier: Apache-2.0
#include "render/allocation.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "sky/camera.h"
#include "trace/expose.h"

namespace parhelion {

namespace {

constexpr std::uint64_t kPilotRays = 1 << 16;
constexpr int kPilotSide = 64;           // pixels of the pilot's picture along its longer side
constexpr double kMostFavour = 4.0;      // and least 1 / 4
constexpr double kRelativeFloor = 0.01;  // of squared luminance, in units of the mean's square: as recon/compare.h

CameraSettings pilotCamera(const CameraSettings& camera) {
  CameraSettings small = camera;
  const double factor = std::min(1.0, static_cast<double>(kPilotSide) / std::max(camera.width, camera.height));
  small.width = std::max(1, static_cast<int>(std::lround(factor * camera.width)));
  small.height = std::max(1, static_cast<int>(std::lround(factor * camera.height)));
  return small;
}

/// The pilot's picture, with a layer for each population.
SkyTally pilotTally(const Scene& scene, const Cloud& cloud) {
  TraceSettings settings = scene.trace;
  settings.rays = kPilotRays;
  settings.paths.layers.clear();
  std::vector<std::string> names;
  for (const Population& population : cloud.populations()) {
    settings.paths.layers.push_back({population.name(), {}, {population.name()}, {}});
    names.push_back(population.name());
  }
  TallyInfo info;
  info.camera = pilotCamera(scene.camera);
  info.white = cloud.spectrum().white();
  info.sunElevation = scene.sun.elevation;
  SkyTally tally(info, cloud.spectrum().colours(), different(symmetriesOf(cloud, settings.symmetry)), names);
  traceTally(tally, cloud, settings);
  return tally;
}

/// Sums over the pixels' neighbourhoods of 3 x 3.
std::vector<double> smoothed(const std::vector<double>& values, int width, int height) {
  std::vector<double> sums(values.size(), 0.0);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      double sum = 0.0;
      int count = 0;
      for (int v = std::max(0, y - 1); v <= std::min(height - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(width - 1, x + 1); ++u, ++count)
          sum += values[static_cast<std::size_t>(v * width + u)];
      sums[static_cast<std::size_t>(y * width + x)] = sum / count;
    }
  return sums;
}

}  // namespace

std::vector<double> favoursFor(const Scene& scene, const Cloud& byLight) {
  const std::size_t populations = byLight.populations().size();
  const auto hasLight = [](double share) { return share > 0.0; };
  if (std::ranges::count_if(byLight.lightShares(), hasLight) < 2 || populations > kMostLayers) return {};
  const SkyTally pilot = pilotTally(scene, byLight);
  const std::vector<double> solidAngles = Camera(pilot.info().camera).solidAngles();

  // Radiance, and squares of what single rays bring to it, both over the same light.
  const auto pixels = static_cast<std::size_t>(pilot.pixels());
  std::vector<double> radiance(pixels, 0.0);
  const auto perLight = [&](const Tally& tally, std::size_t pixel) {
    return solidAngles[pixel] > 0.0 ? 1.0 / (tally.info.interceptedLight() * solidAngles[pixel]) : 0.0;
  };
  for (const SkyTally::Part& part : pilot.parts())
    for (std::size_t i = 0; i < pixels; ++i)
      radiance[i] += part.tally.luminance(static_cast<int>(i)) * perLight(part.tally, i);
  radiance = smoothed(radiance, pilot.width(), pilot.height());
  double light = 0.0, all = 0.0;
  for (std::size_t i = 0; i < pixels; ++i) {
    light += radiance[i] * solidAngles[i];
    all += solidAngles[i];
  }
  if (!(light > 0.0)) return {};
  const double floor = kRelativeFloor * (light / all) * (light / all);

  std::vector<double> favours(populations, 1.0);
  double sum = 0.0;
  for (std::size_t p = 0; p < populations; ++p) {
    const double share = byLight.lightShares()[p];
    double noise = 0.0;
    for (std::size_t s = 0; s < pilot.symmetries().size(); ++s) {
      const Tally& tally = pilot.parts()[p * pilot.symmetries().size() + s].tally;
      for (std::size_t i = 0; i < pixels; ++i) {
        const double per = perLight(tally, i);
        noise += solidAngles[i] * per * per * tally.squares(static_cast<int>(i)) / (radiance[i] * radiance[i] + floor);
      }
    }
    favours[p] = share > 0.0 ? std::sqrt(noise / share) : 0.0;
    sum += share * favours[p];
  }
  if (!(sum > 0.0)) return {};
  for (double& favour : favours) favour = std::clamp(favour / sum, 1.0 / kMostFavour, kMostFavour);
  return favours;
}

}  // namespace parhelion
