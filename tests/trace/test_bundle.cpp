// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "crystals.h"
#include "picture/colour_space.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

Cloud cloudUnder(const SpectrumSettings& spectrum) {
  SunSettings sun;
  sun.spectrum = spectrum;
  const std::vector populations{prismPopulation(1.0)};
  return Cloud(sun, PublishedIndex{}, populations);
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
    RaySource source(cloud, {.seed = 3}, 8);
    for (std::uint64_t bundle = 0; bundle < 50; ++bundle) {
      const IncidentRay first = source.ray(bundle * size);
      for (int k = 1; k < size; ++k) {
        const IncidentRay other = source.ray(bundle * size + k);
        CHECK(other.bundle == first.bundle);
        CHECK(other.lightDirWorld == first.lightDirWorld);
        CHECK(other.crystalToWorld == first.crystalToWorld);
        CHECK(other.entry.point == first.entry.point);
        CHECK(other.light.wavelength > first.light.wavelength);
        CHECK(other.iceIndex < first.iceIndex);
      }
      CHECK(source.ray((bundle + 1) * size).lightDirCrystal != first.lightDirCrystal);
    }
  }
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
    RaySource source(cloud, {}, 256);
    for (int i = 0; i < kRays; ++i) {
      const SpectralSample sample = source.ray(i).light;
      xyz += sample.xyz / double(kRays);
      light += sample.light / kRays;
    }
    // The golden ratio spreads n wavelengths to about 1 / n, where chance would leave 1 / sqrt(n) = 0.7 %.
    CHECK(glm::length(xyz - cloud.spectrum().white()) < 1e-3);
    CHECK(std::abs(light - 1.0) < 1e-3);
  }
}
