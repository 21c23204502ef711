// SPDX-License-Identifier: Apache-2.0
#include "crystal/population.h"

#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include <doctest/doctest.h>

#include "orientations.h"
#include "random_stream.h"
#include "statistics.h"

using namespace parhelion;

namespace {

PopulationSettings prisms(const AspectDistribution& aspect) {
  PopulationSettings settings;
  settings.name = "prisms";
  settings.shape = PrismSettings{aspect};
  return settings;
}

/// The crystal for one number in (0, 1).
Crystal crystalOf(const Population& population, double u) {
  return {&population.mesh(), population.stretch() ? population.stretch()->at(u) : 1.0};
}

std::vector<double> drawAspects(const Population& population, int count) {
  RandomStream random(51, 0, RandomPurpose::incidence);
  std::vector<double> aspects;
  for (int i = 0; i < count; ++i) {
    const Crystal crystal = crystalOf(population, random.next());
    // V / A of the prism, whatever mesh it is stretched from: the height 2 aspect of the vertices.
    double top = 0.0;
    for (const Vec3& v : crystal.mesh->vertices()) top = std::fmax(top, v.z * crystal.stretch);
    aspects.push_back(top);
  }
  return aspects;
}

}  // namespace

TEST_CASE("crystals of one aspect ratio are built at it and need no stretching") {
  const Population population(prisms(FixedValue{0.2}));
  for (const double u : {0.001, 0.5, 0.999}) {
    CHECK(crystalOf(population, u).stretch == 1.0);
    CHECK(crystalOf(population, u).volume() == doctest::Approx(1.5 * std::sqrt(3.0) * 0.4).epsilon(1e-13));
  }
  CHECK(population.name() == "prisms");
}

TEST_CASE("aspect ratios are spread over shares of surface, not weighted by the surface again") {
  constexpr int kDraws = 100000;
  const Population uniform(prisms(UniformRange{0.1, 2.0}));
  CHECK(chiSquareSigma(
            drawAspects(uniform, kDraws), [](double a) { return (a - 0.1) / 1.9; }, 0.1, 2.0, 100) < kSigmas);

  const Population normal(prisms(Normal{1.0, 0.1}));
  const auto cumulative = [](double a) { return 0.5 * std::erfc(-(a - 1.0) / (0.1 * std::sqrt(2.0))); };
  CHECK(chiSquareSigma(drawAspects(normal, kDraws), cumulative, 0.2, 1.8, 100) < kSigmas);
}

TEST_CASE("a wide normal of aspect ratios is cut off at the thinnest plate") {
  for (const double aspect : drawAspects(Population(prisms(Normal{0.01, 0.1})), 10000)) {
    CHECK(aspect >= kThinnestAspect);
    CHECK(aspect <= kLongestAspect);
  }
}

TEST_CASE("a spread of aspect ratios stretches a crystal whose normals it leaves alone") {
  CHECK(Population(prisms(UniformRange{0.1, 2.0})).mesh().isPrismatic());
}

TEST_CASE("a population of pyramids has its shape") {
  PopulationSettings settings;
  settings.shape = PyramidSettings{0.0, 1.0, 1.0};
  const Population population(settings);
  CHECK(population.mesh().faces().size() == 12);
  CHECK(crystalOf(population, 0.3).stretch == 1.0);
}

TEST_CASE("a population's crystals are turned as its orientation says") {
  PopulationSettings settings = prisms(FixedValue{1.0});
  settings.orientation = AxisOrientation{FixedValue{0.7}, FixedValue{0.2}, FixedValue{0.1}};
  const Population population(settings);
  const Mat3 turned = matrixOf(population.orientationQuantile().at(0.3, 0.6, 0.9)),
             expected = crystalOrientation(0.7, 0.2, 0.1);
  for (int k = 0; k < 3; ++k) CHECK(glm::length(turned[k] - expected[k]) < 1e-15);
}

TEST_CASE("a copied population keeps its crystals") {
  auto original = std::make_unique<Population>(prisms(UniformRange{0.5, 1.5}));
  const Population copy = *original;
  original.reset();
  CHECK(copy.mesh().faces().size() == 8);
  CHECK(crystalOf(copy, 0.5).stretch == doctest::Approx(1.0));
}

TEST_CASE("settings that describe no crystal are rejected") {
  PopulationSettings settings = prisms(FixedValue{0.0});
  CHECK_THROWS_AS(Population{settings}, std::invalid_argument);
  for (const AspectDistribution& bad :
       std::initializer_list<AspectDistribution>{Normal{-5.0, 0.1}, Normal{0.0, 0.0}, UniformRange{-1.0, 1.0},
                                                 UniformRange{1.0, 1e5}, UniformRange{1.0, NAN}})
    CHECK_THROWS_AS(Population{prisms(bad)}, std::invalid_argument);
  for (const double bad : {-1.0, std::numeric_limits<double>::quiet_NaN()}) {
    settings = prisms(FixedValue{1.0});
    settings.weight = bad;
    CHECK_THROWS_AS(Population{settings}, std::invalid_argument);
  }
}
