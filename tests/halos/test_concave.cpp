// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "crystal/mesh/mesh_from_obj.h"
#include "crystal/objs.h"
#include "crystal/population.h"
#include "halos/experiment.h"
#include "random_stream.h"
#include "trace/scatter_profile.h"

using namespace parhelion;

namespace {

constexpr int kConcaveBins = 36;

PrismSettings hollow(double aspect, double depth, double width) {
  PrismSettings prism{FixedValue{aspect}};
  prism.upper.cavity = prism.lower.cavity = {depth, width};
  return prism;
}

PrismSettings capped(double aspect, double width, double capAspect) {
  PrismSettings prism{FixedValue{aspect}};
  prism.upper.cap = prism.lower.cap = {width, capAspect};
  return prism;
}

PrismSettings sectors(double aspect, double depth, double width) {
  PrismSettings prism{FixedValue{aspect}};
  prism.notch = {depth, width};
  return prism;
}

ScatterProfile profileOfShape(const ShapeSettings& shape, std::uint64_t rays, Engine engine = Engine::automatic,
                              const OrientationSettings& orientation = RandomOrientation{}, int threads = 0,
                              Sampler sampler = Sampler::random) {
  const Cloud cloud = cloudUnderPointSun(radians(20), {{"crystals", 1.0, shape, orientation}}, ConstantIndex{kIndex});
  ScatterProfile profile(kConcaveBins, 0.0, kPi);
  TraceSettings settings;
  settings.rays = rays;
  settings.engine = engine;
  settings.sampler = sampler;
  TraceControl control;
  control.threads = threads;
  const TraceReport report = traceRays(cloud, settings, 0, profile, control);
  const auto& energy = report.energy;
  CHECK(energy.out.value() + energy.cutOff.value() + energy.lost.value() ==
        doctest::Approx(energy.in.value()).epsilon(1e-9));
  CHECK(energy.lost.value() < 1e-6 * energy.in.value());
  return profile;
}

/// How far two profiles are apart, in standard deviations of the bin that differs most.
double worstSigma(const ScatterProfile& a, const ScatterProfile& b) {
  double worst = 0.0;
  const auto left = a.bins(), right = b.bins();
  for (std::size_t i = 0; i < left.size(); ++i) {
    const double error = std::hypot(left[i].error, right[i].error);
    if (error > 0.0) worst = std::max(worst, std::abs(left[i].energy - right[i].energy) / error);
  }
  return worst;
}

double sigmaOfG(const ScatterProfile& a, const ScatterProfile& b) {
  return std::abs(a.summary().g - b.summary().g) / std::hypot(a.summary().gError, b.summary().gError);
}

}  // namespace

TEST_CASE("a convex OBJ scatters as the built-in prism by both engines, and as triangles that may be met again") {
  const ScatterProfile own = profileOfShape(PrismSettings{FixedValue{0.7}}, 150'000);
  const MeshSettings obj = meshed(objOf(hexagonalPrism(0.7)));
  for (const Engine engine : {Engine::planes, Engine::embree})
    CHECK(worstSigma(own, profileOfShape(obj, 150'000, engine)) < 4.0);
  const ScatterProfile triangles = profileOfShape(asTriangles(hexagonalPrism(0.7)), 150'000);
  CHECK(worstSigma(own, triangles) < 4.0);
  CHECK(triangles.summary().meanProjectedArea == doctest::Approx(own.summary().meanProjectedArea).epsilon(0.005));
}

TEST_CASE("preferred orientations and Sobol' points serve crystals of any form, too") {
  const AxisOrientation tilted{Normal{radians(30), radians(5)}};
  const PyramidSettings pyramid{0.4, 0.7, 0.2};
  const ScatterProfile own = profileOfShape(pyramid, 200'000, Engine::automatic, tilted);
  const MeshSettings triangles = asTriangles(meshOf(pyramid));
  CHECK(worstSigma(own, profileOfShape(triangles, 200'000, Engine::automatic, tilted)) < 4.0);
  const auto sobol = profileOfShape(hollow(1.0, 0.5, 0.7), 200'000, Engine::automatic, tilted, 0, Sampler::sobol);
  CHECK(worstSigma(sobol, profileOfShape(hollow(1.0, 0.5, 0.7), 200'000, Engine::automatic, tilted)) < 4.5);
}

TEST_CASE("two halves that are joined are the whole prism, and two bodies with air between are not") {
  const ScatterProfile whole = profileOfShape(PrismSettings{FixedValue{1.0}}, 200'000);
  CHECK(worstSigma(whole, profileOfShape(meshed(joinedHalves(1.0)), 200'000)) < 4.0);
  const ScatterProfile halves = profileOfShape(meshed(halvesOf(1.0, 1e-4)), 200'000);
  CHECK(whole.summary().g == doctest::Approx(0.542).epsilon(0.004));
  CHECK(halves.summary().g == doctest::Approx(0.485).epsilon(0.006));
}

TEST_CASE("pits that vanish leave the prism, and deep ones change it") {
  const ScatterProfile prism = profileOfShape(PrismSettings{FixedValue{2.0}}, 150'000);
  const ScatterProfile shallow = profileOfShape(hollow(2.0, 1e-3, 0.8), 150'000);
  CHECK(sigmaOfG(prism, shallow) < 4.0);
  CHECK(sigmaOfG(prism, profileOfShape(hollow(2.0, 0.4, 0.8), 150'000)) > 10.0);
}

TEST_CASE("caps and notches that vanish leave the prism, and others change it") {
  const ScatterProfile column = profileOfShape(PrismSettings{FixedValue{2.0}}, 150'000);
  CHECK(worstSigma(column, profileOfShape(capped(1.6, 1.0, 0.2), 150'000)) < 4.0);
  CHECK(sigmaOfG(column, profileOfShape(capped(1.6, 1.001, 0.2), 150'000)) < 4.0);
  CHECK(sigmaOfG(column, profileOfShape(capped(1.6, 2.5, 0.2), 150'000)) > 10.0);
  const ScatterProfile plate = profileOfShape(PrismSettings{FixedValue{0.3}}, 150'000);
  CHECK(sigmaOfG(plate, profileOfShape(sectors(0.3, 1e-3, 0.5), 150'000)) < 4.0);
  CHECK(sigmaOfG(plate, profileOfShape(sectors(0.3, 0.8, 0.5), 150'000)) > 10.0);
}

TEST_CASE("the mean path inside a crystal of any form is n^2 times its volume over its mean silhouette") {
  const auto check = [](const ShapeSettings& shape) {
    const ScatterProfile::Summary s = profileOfShape(shape, 200'000).summary();
    const double expected = kIndex * kIndex * s.volume / s.meanProjectedArea;
    CHECK(s.meanPath == doctest::Approx(expected).epsilon(0.01));
  };
  check(hollow(1.0, 0.6, 0.8));
  check(meshed(halvesOf(1.0, 0.5)));
  check(capped(1.5, 2.5, 0.1));
  check(sectors(0.3, 0.7, 0.4));
  check(RosetteSettings{6, 1.0});
  check(RosetteSettings{5, 0.8, radians(35.0), 0.5});
}

TEST_CASE("the silhouette of a crystal that is not convex is that of rays cast at it") {
  const EmbreeDevice device;
  const auto check = [&](const CrystalMesh& mesh) {
    const ScatterProfile::Summary s = profileOfShape(meshed(mesh), 200'000).summary();
    const ConcaveCrystal crystal(device, mesh);
    RandomStream random(3, 0, RandomPurpose::path);
    constexpr int kCast = 200'000;
    int met = 0;
    for (int i = 0; i < kCast; ++i) {
      const double z = 2.0 * random.next() - 1.0, turn = 2.0 * kPi * random.next(), w = std::sqrt(1.0 - z * z);
      const Vec3 dir(w * std::cos(turn), w * std::sin(turn), z);
      const Vec3 side = glm::normalize(glm::cross(dir, std::abs(z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0)));
      const double r = mesh.radius() * std::sqrt(random.next()), at = 2.0 * kPi * random.next();
      const Vec3 point = r * (std::cos(at) * side + std::sin(at) * glm::cross(dir, side)) - 2.0 * mesh.radius() * dir;
      met += crystal.nextFace(point, dir, kNoFace, Side::outside).has_value();
    }
    const double disc = kPi * mesh.radius() * mesh.radius(), share = static_cast<double>(met) / kCast;
    const double error = disc * std::sqrt(share * (1.0 - share) / kCast);
    // A pit casts no light-free shadow: less than a quarter of the surface, by some sigma.
    CHECK(disc * share < 0.25 * s.surface - 20.0 * error);
    CHECK(std::abs(s.meanProjectedArea - disc * share) < 4.0 * 1.5 * error);
  };
  check(meshFromObj(halvesOf(1.0, 0.5)));
  check(meshOf(capped(1.5, 2.5, 0.1)));
  check(meshOf(sectors(0.3, 0.7, 0.4)));
  check(meshOf(RosetteSettings{6, 1.0}));
  check(meshOf(RosetteSettings{8, 0.6, radians(28.0), 0.5}));
}

TEST_CASE("a hollow column casts the shadow of the plain one") {
  const double plain = profileOfShape(PrismSettings{FixedValue{1.0}}, 100'000).summary().meanProjectedArea;
  CHECK(profileOfShape(hollow(1.0, 0.8, 0.9), 200'000).summary().meanProjectedArea ==
        doctest::Approx(plain).epsilon(0.01));
}

TEST_CASE("light in crystals of any form is the same bits for any number of threads") {
  const auto one = profileOfShape(hollow(1.0, 0.6, 0.8), 50'000, Engine::automatic, RandomOrientation{}, 1).bins();
  const auto three = profileOfShape(hollow(1.0, 0.6, 0.8), 50'000, Engine::automatic, RandomOrientation{}, 3).bins();
  for (std::size_t i = 0; i < one.size(); ++i) CHECK(one[i].energy == three[i].energy);
}
