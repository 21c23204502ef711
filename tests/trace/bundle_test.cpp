// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "crystals.h"
#include "image/colour_space.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

Cloud cloudUnder(const SpectrumSettings& spectrum) {
  SunSettings sun;
  sun.spectrum = spectrum;
  const std::vector populations{prismPopulation(1.0)};
  return Cloud(sun, TabulatedIce{}, populations);
}

struct Moments {
  double luminance, chroma;  // second moments a ray, of light that dispersion does not part
};

/// Continuous sunlight in bundles of `size` rays at equal distances in the spectrum.
Moments momentsOfBundles(int size) {
  const Spectrum spectrum{ContinuousSpectrum{}};
  const Mat3 toRgb = xyzToRec709(spectrum.white());
  constexpr int kBundles = 5000;
  Moments moments{0.0, 0.0};
  for (int i = 0; i < kBundles; ++i) {
    Vec3 xyz(0.0);
    for (int k = 0; k < size; ++k) xyz += spectrum.sample((k + (i + 0.5) / kBundles) / size).xyz;
    const Vec3 colour = toRgb * xyz - Vec3(xyz.y);
    moments.luminance += xyz.y * xyz.y / (kBundles * size);
    moments.chroma += glm::dot(colour, colour) / (kBundles * size);
  }
  return moments;
}

}  // namespace

TEST_CASE("the rays of a bundle differ in wavelength and in nothing else") {
  for (const auto& [spectrum, size] : std::vector<std::pair<SpectrumSettings, int>>{
           {ContinuousSpectrum{}, 2}, {LineSpectrum{{450.0, 550.0, 650.0}}, 3}, {MonochromaticSpectrum{500.0}, 1}}) {
    const Cloud cloud = cloudUnder(spectrum);
    REQUIRE(cloud.bundleSize() == size);
    for (std::uint64_t bundle = 0; bundle < 50; ++bundle) {
      const IncidentRay first = cloud.incidentRay(3, bundle * size);
      for (int k = 1; k < size; ++k) {
        const IncidentRay other = cloud.incidentRay(3, bundle * size + k);
        CHECK(other.bundle == first.bundle);
        CHECK(other.lightDirWorld == first.lightDirWorld);
        CHECK(other.crystalToWorld == first.crystalToWorld);
        CHECK(other.entry.point == first.entry.point);
        CHECK(other.light.wavelength > first.light.wavelength);
        CHECK(other.iceIndex < first.iceIndex);
      }
      CHECK(cloud.incidentRay(3, (bundle + 1) * size).lightDirCrystal != first.lightDirCrystal);
    }
  }
}

TEST_CASE("a bundle is the rays it is made of, also when the last one is cut short") {
  const Cloud cloud = cloudUnder(LineSpectrum{{450.0, 550.0, 650.0}});
  const Engines engines = makeEngines(cloud, Engine::embree);
  TraceSettings settings;
  settings.rays = 1000;
  std::vector<LightPath> bundle;
  LightPath single;
  std::uint64_t rays = 0;
  for (std::uint64_t b = 0; 3 * b < settings.rays; ++b) {
    followBundle(cloud, engines, settings, b, bundle);
    for (const LightPath& path : bundle) {
      followRay(cloud, engines, settings, rays, single);
      REQUIRE(path.incident.index == rays++);
      REQUIRE(path.exits.size() == single.exits.size());
      for (std::size_t k = 0; k < path.exits.size(); ++k) {
        REQUIRE(path.exits[k].lightDirWorld == single.exits[k].lightDirWorld);
        REQUIRE(path.exits[k].energy == single.exits[k].energy);
      }
    }
  }
  CHECK(rays == 1000);
}

TEST_CASE("a pair of wavelengths has a quarter of the colour noise of single rays for a third more luminance noise") {
  const Moments single = momentsOfBundles(1), pair = momentsOfBundles(2);
  MESSAGE("colour " << pair.chroma / single.chroma << ", luminance " << pair.luminance / single.luminance);
  CHECK(pair.chroma < 0.27 * single.chroma);
  CHECK(pair.luminance < 1.34 * single.luminance);
}

TEST_CASE("bundles keep the sun white and their light fair") {
  for (const SpectrumSettings& spectrum :
       std::vector<SpectrumSettings>{ContinuousSpectrum{}, LineSpectrum{{450.0, 600.0}}}) {
    const Cloud cloud = cloudUnder(spectrum);
    Vec3 xyz(0.0);
    double light = 0.0;
    constexpr int kRays = 20'000;
    for (int i = 0; i < kRays; ++i) {
      const SpectralSample sample = cloud.incidentRay(1, i).light;
      xyz += sample.xyz / double(kRays);
      light += sample.light / kRays;
    }
    // The golden ratio spreads n wavelengths to about 1 / n, where chance would leave 1 / sqrt(n) = 0.7 %.
    CHECK(glm::length(xyz - cloud.spectrum().white()) < 1e-3);
    CHECK(std::abs(light - 1.0) < 1e-3);
  }
}
