// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "crystal/population.h"
#include "halos/experiment.h"
#include "trace/scatter_profile.h"

using namespace parhelion;

namespace {

constexpr int kBins = 36;

PopulationSettings crystals(const ShapeSettings& shape, const OrientationSettings& orientation = RandomOrientation{}) {
  return {"crystals", 1.0, shape, orientation};
}

Cloud cloudOf(const std::vector<PopulationSettings>& populations, double index = kIndex) {
  return cloudUnderPointSun(radians(20), populations, ConstantIndex{index});
}

ScatterProfile profileOf(const Cloud& cloud, std::uint64_t rays, const TraceSettings& settings = {}, int threads = 0) {
  ScatterProfile profile(kBins, 0.0, kPi);
  TraceSettings own = settings;
  own.rays = rays;
  TraceControl control;
  control.threads = threads;
  traceRays(cloud, own, 0, profile, control);
  return profile;
}

ShapeSpread sidesDrawn(std::array<bool, 6> which, const LengthDistribution& distribution) {
  return {ShapeLength::sides, which, distribution};
}

/// Each side by itself.
PrismSettings anySides(double aspect, const LengthDistribution& distribution) {
  PrismSettings prism{FixedValue{aspect}};
  for (std::size_t k = 0; k < 6; ++k) {
    std::array<bool, 6> one{};
    one[k] = true;
    prism.spreads.push_back(sidesDrawn(one, distribution));
  }
  return prism;
}

PyramidSettings anyPyramids() {
  PyramidSettings pyramid{0.4};
  pyramid.spreads = {{ShapeLength::upper, {}, Normal{0.5, 0.2}},
                     {ShapeLength::lower, {}, UniformRange{0.0, 1.0}},
                     {ShapeLength::lowerSlope, {}, Laplace{radians(28), radians(4)}},
                     {ShapeLength::aspect, {}, LogNormal{0.4, 0.5}},
                     sidesDrawn({true, false, true, false, true, false}, UniformRange{0.7, 1.3})};
  return pyramid;
}

/// The angle (degrees) at which light begins that a wedge refracts.
double edgeOf(const Cloud& cloud, double from, double to) {
  ScatterProfile profile(400, radians(from), radians(to));
  traceRays(cloud, {.rays = 2'000'000}, 0, profile);
  const auto bins = profile.bins();
  std::size_t steepest = 1;
  for (std::size_t k = 1; k < bins.size(); ++k)
    if (bins[k].energy - bins[k - 1].energy > bins[steepest].energy - bins[steepest - 1].energy) steepest = k;
  return from + static_cast<double>(steepest) * (to - from) / 400.0;
}

double leastDeviation(double wedgeDegrees, double index = kIndex) {
  return degrees(2.0 * std::asin(index * std::sin(radians(0.5 * wedgeDegrees)))) - wedgeDegrees;
}

/// A crystal of planes as far from its middle.
PlanesSettings crystalOf(const std::vector<Vec3>& normals) {
  PlanesSettings crystal;
  for (const Vec3& normal : normals)
    crystal.planes.push_back({static_cast<int>(crystal.planes.size()) + 1, glm::normalize(normal), 1.0});
  return crystal;
}

}  // namespace

TEST_CASE("an octahedron's wedge of 70.529 degrees makes a ring at 27.754 degrees, cut out of planes") {
  PlanesSettings octahedron;
  const double third = 1.0 / std::sqrt(3.0);
  for (int i = 0; i < 8; ++i)
    octahedron.planes.push_back(
        {i + 1, Vec3(i & 1 ? -third : third, i & 2 ? -third : third, i & 4 ? -third : third), 1.0});
  CHECK(leastDeviation(70.5287794) == doctest::Approx(27.754).epsilon(1e-4));
  CHECK(std::abs(edgeOf(cloudOf({crystals(octahedron)}), 26.0, 30.0) - 27.754) < 0.011);
}

TEST_CASE("crystals of CO2 ice, of index 1.41, make rings at 29.659 degrees by 60 and 81.152 degrees by 90") {
  CHECK(leastDeviation(60.0, 1.41) == doctest::Approx(29.659).epsilon(2e-5));
  CHECK(leastDeviation(90.0, 1.41) == doctest::Approx(81.152).epsilon(2e-5));
  std::vector<Vec3> dodecahedron, cube;
  for (int axis = 0; axis < 3; ++axis)
    for (const double a : {-1.0, 1.0}) {
      Vec3 square(0.0);
      square[axis] = a;
      cube.push_back(square);
      for (const double b : {-1.0, 1.0}) {
        square[(axis + 1) % 3] = b;
        dodecahedron.push_back(square);
      }
    }
  // The edge of the latter is too faint to be fitted: what goes through two faces alone is looked at one by one.
  const auto least = [](const std::vector<Vec3>& normals) {
    double angle = kPi;
    forEachRay(cloudOf({crystals(crystalOf(normals))}, 1.41), 400'000, [&](const LightPath& path) {
      for (const Exit& exit : path.exits)
        if (exit.order == 1 && !exit.undeviated)
          angle = std::min(angle, angleBetween(path.incident.lightDirWorld, exit.lightDirWorld));
    });
    return degrees(angle);
  };
  for (const auto& [normals, expected] : {std::pair(dodecahedron, 29.659), {cube, 81.152}}) {
    const double found = least(normals);
    CHECK(found > expected - 1e-3);
    CHECK(found < expected + 2e-2);
  }
}

TEST_CASE("pyramids of {20-21} on one end and {10-12} on the other stand at their own slopes") {
  PyramidSettings pyramid{0.3, 0.5, 0.5};
  pyramid.upperSlope = slopeOfMiller(2, 1);
  pyramid.lowerSlope = slopeOfMiller(1, 2);
  const CrystalMesh mesh = meshOf(pyramid);
  for (const Face& face : mesh.faces()) {
    if (face.number >= 13 && face.number <= 18) CHECK(std::abs(std::asin(face.normal.z) - *pyramid.upperSlope) < 1e-12);
    if (face.number >= 23) CHECK(std::abs(std::asin(-face.normal.z) - *pyramid.lowerSlope) < 1e-12);
  }
}

TEST_CASE("a triangular prism scatters as its planes do in another order, by both engines") {
  const ShapeSettings triangle = PrismSettings{FixedValue{0.6}, {1.0, 2.5, 1.0, 2.5, 1.0, 2.5}};
  PlanesSettings planes;
  for (const FacePlane& plane : sidePlanes({1.0, 2.5, 1.0, 2.5, 1.0, 2.5}))
    planes.planes.insert(planes.planes.begin(), plane);
  for (const FacePlane& plane : endPlanes(0.6, -0.6)) planes.planes.push_back(plane);
  const ScatterProfile one = profileOf(cloudOf({crystals(triangle)}), 400'000),
                       other = profileOf(cloudOf({crystals(planes)}), 400'000, {.seed = 2, .engine = Engine::embree});
  for (int k = 0; k < kBins; ++k) {
    CAPTURE(k);
    const auto a = one.bins()[k], b = other.bins()[k];
    CHECK(std::abs(a.energy - b.energy) < 4.5 * std::hypot(a.error, b.error) + 1e-9);
  }
}

TEST_CASE("shapes that are spread scatter as a mixture of many fixed shapes") {
  for (const auto& [shape, orientation] : std::vector<std::pair<ShapeSettings, OrientationSettings>>{
           {anySides(0.5, UniformRange{0.4, 1.6}), RandomOrientation{}},
           {anySides(0.2, Normal{1.0, 0.3}), AxisOrientation{Normal{0.0, radians(2)}}},
           {anyPyramids(), RandomOrientation{}}}) {
    const PopulationSettings spread = crystals(shape, orientation);
    const ScatterProfile one = profileOf(cloudOf({spread}), 1'000'000),
                         other = profileOf(cloudOf(withFixedShapes(spread, 300)), 1'000'000, {.seed = 2});
    for (int k = 0; k < kBins; ++k) {
      CAPTURE(k);
      const auto a = one.bins()[k], b = other.bins()[k];
      CHECK(std::abs(a.energy - b.energy) < 4.5 * std::hypot(a.error, b.error) + 0.004 * b.energy);
    }
  }
}

TEST_CASE("shapes that are spread keep their bits however a run is divided, and close the ledger") {
  const Cloud cloud = cloudOf({crystals(anySides(0.5, UniformRange{-0.3, 1.6})), crystals(anyPyramids())});
  const ScatterProfile one = profileOf(cloud, 60'000, {}, 1), three = profileOf(cloud, 60'000, {}, 3);
  for (int k = 0; k < kBins; ++k) CHECK(one.bins()[k].energy == three.bins()[k].energy);
  double worst = 0.0;
  forEachRay(cloud, 60'000, [&](const LightPath& path) {
    double out = path.cutOff + path.lost;
    for (const Exit& exit : path.exits) out += exit.energy;
    worst = std::max(worst, std::abs(out - path.incident.weight));
  });
  CHECK(worst < 1e-12);
}

TEST_CASE("the mean internal path of crystals of any shape is n^2 4V/S") {
  constexpr double kLow = 1.2;  // so that no light is trapped
  const PopulationSettings spread = crystals(anySides(0.5, UniformRange{0.4, 1.6}));
  const Population population(spread);
  double expected = 0.0;
  constexpr int kShapes = 2000;
  for (int k = 0; k < kShapes; ++k) {
    const CrystalMesh mesh = population.crystalOfBlock(0, static_cast<std::uint64_t>(k)).second;
    expected += kLow * kLow * 4.0 * mesh.volume() / Crystal{&mesh}.surface() / kShapes;
  }
  SampleMean path, weight;
  forEachRay(cloudOf({spread}, kLow), 400'000, [&](const LightPath& one) {
    path.add(one.internalPath);
    weight.add(one.incident.weight);
  });
  // Rays weigh 1 on average, and rays of a block share a shape.
  CHECK(std::abs(path.mean() / weight.mean() - expected) < 0.01 * expected);
}
