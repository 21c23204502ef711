// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>

#include "halos/closed_forms.h"
#include "halos/edge_fit.h"

using namespace parhelion;

namespace {

/// Light over the angle from the sun's centre (degrees).
Histogram aroundSun(const Cloud& cloud, std::uint64_t rays, Histogram histogram) {
  forEachRay(cloud, rays, [&](const LightPath& path) {
    for (const Exit& exit : path.exits)
      histogram.add(degrees(angleBetween(cloud.sun().toCentre(), -exit.lightDirWorld)), exit.energy);
  });
  return histogram;
}

/// Mean wavelength of light in a range of some angle, energy weighted.
struct MeanWavelength {
  double from, to;
  double sum = 0.0, energy = 0.0;

  void add(double x, const LightPath& path, const Exit& exit) {
    if (x < from || x >= to) return;
    sum += exit.energy * path.incident.light.wavelength;
    energy += exit.energy;
  }
  double value() const { return sum / energy; }
};

Cloud colouredCloud(const PopulationSettings& crystals) {
  return Cloud({radians(20), 0.0, ContinuousSpectrum{}, false}, PublishedIndex{}, {&crystals, 1});
}

}  // namespace

TEST_CASE("the sun's disc softens the ring's edge over its own radius and leaves it in its place") {
  const PopulationSettings crystals = prisms(1.0, RandomOrientation{});
  const double expected = degrees(theory::leastDeviation(radians(60), kIndex));
  const auto edgeUnder = [&](double diameter) {
    const Cloud cloud({radians(20), radians(diameter), MonochromaticSpectrum{}, false}, ConstantIndex{kIndex},
                      {&crystals, 1});
    return fitSoftEdge(aroundSun(cloud, 1'000'000, Histogram(expected - 1, expected + 1, 200)), 0.4);
  };
  const EdgeFit point = edgeUnder(0.0), disc = edgeUnder(0.533);
  CHECK(point.softness < 0.03);
  CHECK(std::abs(disc.position - expected) < 0.02);
  // Limb darkening makes the disc work like an evenly bright one of the same mean square radius.
  double light = 0.0, squares = 0.0;
  for (double r = 0.0005; r < 1.0; r += 0.001) {
    light += r * limbDarkening(r);
    squares += r * r * r * limbDarkening(r);
  }
  CHECK(std::abs(disc.softness - 0.2665 * std::sqrt(2.0 * squares / light)) < 0.02);
}

TEST_CASE("the 22 degree ring is red inside") {
  MeanWavelength hole{20.5, 21.5}, inside{21.7, 21.9}, ring{22.3, 22.6};
  forEachRay(colouredCloud(prisms(1.0, RandomOrientation{})), 1'000'000, [&](const LightPath& path) {
    for (const Exit& exit : path.exits) {
      const double angle = degrees(angleBetween(path.incident.lightDirWorld, exit.lightDirWorld));
      for (MeanWavelength* m : {&hole, &inside, &ring}) m->add(angle, path, exit);
    }
  });
  CHECK(inside.value() > hole.value() + 20.0);
  CHECK(inside.value() > ring.value() + 20.0);
}

TEST_CASE("the circumzenithal arc is red toward the sun, below, and violet toward the zenith") {
  const double red = degrees(theory::circumzenithal(1.3080, radians(20)));     // 650 nm
  const double violet = degrees(theory::circumzenithal(1.3157, radians(20)));  // 450 nm
  CHECK(red < violet);
  MeanWavelength below{red - 0.1, red + 0.1}, above{violet - 0.1, violet + 0.1};
  forEachRay(colouredCloud(prisms(0.2, plateOrientation())), 300'000, [&](const LightPath& path) {
    for (const Exit& exit : path.exits)
      for (MeanWavelength* m : {&below, &above}) m->add(seenAt(exit.lightDirWorld).elevation, path, exit);
  });
  CHECK(std::abs(below.value() - 650.0) < 15.0);
  CHECK(std::abs(above.value() - 450.0) < 15.0);
}
