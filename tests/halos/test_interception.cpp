// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "halos/experiment.h"
#include "trace/scatter_profile.h"

using namespace parhelion;

namespace {

// Shadows of hexagonal prisms with side 1: of a basal face seen head on, and of the sides seen square on per unit of
// length along c, averaged over all rolls.
constexpr double kBasal = 2.598076211353316;  // 3 sqrt(3) / 2
constexpr double kSides = 6.0 / kPi;

double plateShadow(double aspect, double sun) { return kBasal * std::sin(sun) + kSides * 2.0 * aspect * std::cos(sun); }

/// Horizontal columns of every azimuth.
double columnShadow(double aspect, double sun) {
  constexpr int kSteps = 20'000;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double along = std::cos(sun) * std::cos(2.0 * kPi * (i + 0.5) / kSteps);  // cosine of light and axis
    sum += kBasal * std::abs(along) + kSides * 2.0 * aspect * std::sqrt(1.0 - along * along);
  }
  return sum / kSteps;
}

double surface(double aspect) { return 12.0 * aspect + 2.0 * kBasal; }

/// The mean shadow of the crystals that a profile's summary gives, against its expectation.
void checkShadow(const Cloud& cloud, double expected) {
  constexpr std::uint64_t kRays = 200'000;
  ScatterProfile profile(1, 0.0, kPi);
  traceRays(cloud, {.rays = kRays}, 0, profile);
  RaySource source(cloud, {}, 256);
  SampleMean perShadow;  // rays come in proportion to the shadow; its inverse counts crystals
  for (std::uint64_t i = 0; i < kRays; ++i) {
    const IncidentRay ray = source.ray(i);
    perShadow.add(ray.weight / ray.shadow);
  }
  const double relativeError = perShadow.standardError() / perShadow.mean();
  // Where all crystals have one shadow there is no scatter but rounding.
  CHECK(std::abs(profile.summary().meanProjectedArea / expected - 1.0) < 4.0 * relativeError + 1e-9);
}

}  // namespace

TEST_CASE("perfect plates and columns intercept light by the mean of their shadows") {
  for (const double degreesUp : {0.0, 20.0, 60.0, 90.0}) {
    CAPTURE(degreesUp);
    const double sun = radians(degreesUp);
    checkShadow(cloudUnderPointSun(sun, {prisms(0.2, plateOrientation())}), plateShadow(0.2, sun));
    checkShadow(cloudUnderPointSun(sun, {prisms(3.0, columnOrientation())}), columnShadow(3.0, sun));
  }
}

TEST_CASE("two populations share the rays by weight times mean shadow over surface") {
  constexpr double kPlateAspect = 0.1, kColumnAspect = 3.0, kPlateWeight = 0.7, kColumnWeight = 0.3;
  for (const double degreesUp : {0.0, 20.0, 60.0, 90.0}) {
    CAPTURE(degreesUp);
    const double sun = radians(degreesUp);
    const Cloud cloud = cloudUnderPointSun(sun, {prisms(kPlateAspect, plateOrientation(), kPlateWeight),
                                                 prisms(kColumnAspect, columnOrientation(), kColumnWeight)});
    const double toPlates = kPlateWeight * plateShadow(kPlateAspect, sun) / surface(kPlateAspect);
    const double toColumns = kColumnWeight * columnShadow(kColumnAspect, sun) / surface(kColumnAspect);
    const double expected = toPlates / (toPlates + toColumns);

    RaySource source(cloud, {}, 256);
    SampleMean plates;
    double heaviest = 1.0;
    for (std::uint64_t i = 0; i < 400'000; ++i) {
      const IncidentRay ray = source.ray(i);
      heaviest = std::max(heaviest, ray.weight);
      plates.add(ray.population == 0 ? ray.weight : 0.0);
    }
    CHECK(plates.sigmasFrom(expected) < 4.0);
    CHECK(heaviest < 1.1);
  }
}

TEST_CASE("a population's weight is its share of surface: spread over aspect ratios it means the same") {
  // Randomly oriented crystals intercept a quarter of their surface, whatever their shapes.
  const std::vector<PopulationSettings> populations{
      {"spread", 1.0, PrismSettings{UniformRange{0.05, 8.0}}, RandomOrientation{}},
      prisms(0.3, RandomOrientation{}, 2.0),
      {"pyramids", 3.0, PyramidSettings{0.4, 0.5, 1.0}, RandomOrientation{}}};
  const Cloud cloud = cloudUnderPointSun(radians(20), populations);
  RaySource source(cloud, {}, 256);
  SampleMean share[3];
  for (std::uint64_t i = 0; i < 400'000; ++i) {
    const IncidentRay ray = source.ray(i);
    for (int p = 0; p < 3; ++p) share[p].add(ray.population == p ? ray.weight : 0.0);
  }
  for (int p = 0; p < 3; ++p) CHECK(share[p].sigmasFrom((p + 1) / 6.0) < 4.0);
}
