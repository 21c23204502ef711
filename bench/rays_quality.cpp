// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "csv.h"
#include "math/rotation.h"
#include "rays_configurations.h"
#include "rays_plan.h"
#include "sky/camera.h"
#include "stopwatch.h"
#include "trace/expose.h"
#include "trace/trace.h"

namespace parhelion::bench {
namespace {

constexpr double kWanted = 0.01;  // relative noise of a pixel
constexpr double kSunElevation = radians(20.0);

/// Columns in random orientation, in a panorama of 2048 x 1024 pixels.
Cloud columns() {
  const SunSettings sun{.elevation = kSunElevation, .diameter = 0.0, .spectrum = MonochromaticSpectrum{550.0}};
  const PopulationSettings columns{"columns", 1.0, PrismSettings{FixedValue{2.0}}, RandomOrientation{}};
  return Cloud(sun, PublishedIndex{}, {{columns}});
}

SkyTally panorama(const std::vector<TallySymmetry>& symmetries) {
  TallyInfo info;
  info.sunElevation = kSunElevation;
  info.camera.projection = Projection::equirectangular;
  info.camera.elevation = 0.0;
  info.camera.fieldOfView = 2.0 * kPi;
  info.camera.width = 2048;
  info.camera.height = 1024;
  return SkyTally(info, 1, symmetries);
}

/// Root mean square of the relative standard errors of the pixels in the ring 22-24 degrees about the sun.
double ringNoise(const Tally& tally, const Vec3& toSun) {
  const Camera camera(tally.info.camera);
  double sum = 0.0, pixels = 0.0;
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) {
    const auto toSky = camera.toSky({pixel % tally.width() + 0.5, pixel / tally.width() + 0.5});
    const double angle = degrees(angleBetween(*toSky, toSun));
    if (angle < 22.0 || angle > 24.0 || tally.luminance(pixel) == 0.0) continue;
    const double noise = tally.luminanceError(pixel) / tally.luminance(pixel);
    sum += noise * noise;
    pixels += 1.0;
  }
  return std::sqrt(sum / pixels);
}

}  // namespace

void measureQuality(const RaysPlan& plan) {
  Csv csv(
      plan.results / "rays_quality.csv",
      "Columns of aspect 2 in random orientation, sun 20 degrees high, 550 nm, point sun, panorama of 2048 x 1024 "
      "pixels, seed 1, one thread.\nnoise: root mean square of the pixels' relative standard errors, 22 to 24 degrees "
      "from the sun. wanted_cpu_seconds: for 1 % noise, by the square of the noise.",
      "symmetry,rays,cpu_seconds,fixed_cpu_seconds,noise,wanted_cpu_seconds");
  const Cloud cloud = columns();
  const std::uint64_t rays = plan.quick ? 10'000'000 : 100'000'000;
  for (const auto& [symmetry, name, share] : {std::tuple{Symmetry::none, "none", 1.0},
                                              {Symmetry::mirror, "mirror", 1.0},
                                              {Symmetry::radial, "radial", 0.01}}) {
    const auto run = [&](std::uint64_t count, SkyTally& tally) {
      TraceSettings settings = tracing(Engine::planes);
      settings.rays = count;
      settings.symmetry = symmetry;
      const Stopwatch watch;
      traceTally(tally, cloud, settings, 0, {.threads = 1, .onProgress = {}});
      return watch.read().cpuSeconds;
    };
    // What a run costs however few its rays.
    const auto symmetries = different(symmetriesOf(cloud, symmetry));
    SkyTally empty = panorama(symmetries), tally = panorama(symmetries);
    const double fixed = run(1, empty);
    const auto count = static_cast<std::uint64_t>(share * static_cast<double>(rays));
    const double seconds = run(count, tally), noise = ringNoise(tally.flattened(), cloud.sun().toCentre());
    csv.row(name, count, seconds, fixed, noise, fixed + (seconds - fixed) * noise * noise / (kWanted * kWanted));
  }
}

}  // namespace parhelion::bench
