// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <vector>

#include "halos/comparison.h"
#include "halos/experiment.h"

using namespace parhelion;

namespace {

std::vector<PopulationSettings> mixture() {
  return {prisms(0.1, AxisOrientation{Normal{0.0, radians(2)}, kFree, kFree}),
          prisms(3.0, AxisOrientation{Normal{0.5 * kPi, radians(2)}, kFree, kFree}, 2.0),
          prisms(1.0, RandomOrientation{}, 3.0),
          {"pyramids", 1.0, PyramidSettings{0.4, 0.5, 0.5}, RandomOrientation{}}};
}

SkyMap mapOf(const TraceSettings& settings) {
  const Cloud cloud({radians(25), 0.0, MonochromaticSpectrum{}, false}, ConstantIndex{kIndex}, mixture());
  SkyMap map(cloud.sun().toCentre(), 60);
  traceRays(cloud, settings, 0, map);
  return map;
}

constexpr std::uint64_t kRays = 1'000'000;

}  // namespace

TEST_CASE("splitting the light at every face and following one branch by chance give the same sky") {
  const Disagreement d = compareMaps(mapOf({.rays = kRays, .seed = 11, .path = PathMode::split}),
                                     mapOf({.rays = kRays, .seed = 12, .path = PathMode::chance}));
  CHECK(d.compared() > 1000);
  CHECK(std::abs(d.sigmas()) < 4.0);
}

TEST_CASE("Embree's two modes and the planes give the same sky") {
  const SkyMap embree = mapOf({.rays = kRays, .seed = 21, .engine = Engine::embree});
  for (const Engine other : {Engine::embreeRobust, Engine::planes}) {
    const Disagreement d = compareMaps(embree, mapOf({.rays = kRays, .seed = 22, .engine = other}));
    CHECK(d.compared() > 1000);
    CHECK(std::abs(d.sigmas()) < 4.0);
  }
}

TEST_CASE("a ray's wavelength has nothing to do with its way: with one index, all tenths of the spectrum see one sky") {
  // Wavelengths are spread evenly over consecutive rays; an echo of that in the geometry would show here.
  const Cloud cloud({radians(25), 0.0, ContinuousSpectrum{}, false}, ConstantIndex{kIndex}, mixture());
  constexpr int kTenths = 10, kBins = 30;
  std::vector<BundleBins> light(kTenths, BundleBins(kBins));
  std::array<std::uint64_t, kTenths> rays{};
  std::array<double, kTenths> border{};
  for (int i = 0; i < kTenths; ++i) border[i] = cloud.spectrum().sample(i / double(kTenths)).wavelength;
  BundleDeposits<double> deposits;
  forEachRay(cloud, kRays, [&](const LightPath& path) {
    int tenth = kTenths - 1;
    while (path.incident.light.wavelength < border[tenth]) --tenth;
    deposits.clear();
    for (const Exit& exit : path.exits) {
      const double angle = angleBetween(path.incident.lightDirWorld, exit.lightDirWorld);
      deposits.add(std::min(kBins - 1, static_cast<int>(angle / kPi * kBins)), exit.energy);
    }
    light[tenth].add(deposits);
    ++rays[tenth];
  });
  Disagreement d;
  for (int tenth = 0; tenth < kTenths; tenth += 2)
    for (int bin = 0; bin < kBins; ++bin) {
      const auto mean = [&](int t) { return light[t].light(bin) / rays[t]; };
      const auto error = [&](int t) { return light[t].error(bin, rays[t]) / rays[t]; };
      d.add(mean(tenth), error(tenth), mean(tenth + 1), error(tenth + 1));
    }
  CHECK(d.compared() == kTenths / 2 * kBins);
  CHECK(std::abs(d.sigmas()) < 4.0);
}

TEST_CASE("evenly spread wavelengths have the spectrum's white as their mean, far closer than chance would bring it") {
  const Cloud cloud({radians(25), 0.0, ContinuousSpectrum{}, false}, ConstantIndex{kIndex}, mixture());
  constexpr std::uint64_t kFew = 100'000;
  RaySource source(cloud, {}, 256);
  Vec3 sum(0.0);
  double light = 0.0;
  for (std::uint64_t i = 0; i < kFew; ++i) {
    const SpectralSample sample = source.ray(i).light;
    sum += sample.xyz / double(kFew);
    light += sample.light / double(kFew);
  }
  // Independent draws would scatter by some 3e-3.
  for (int i = 0; i < 3; ++i) CHECK(sum[i] == doctest::Approx(cloud.spectrum().white()[i]).epsilon(2e-4));
  CHECK(light == doctest::Approx(1.0).epsilon(2e-4));
}
