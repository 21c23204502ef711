// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "halos/closed_forms.h"
#include "halos/experiment.h"
#include "optics/interface.h"
#include "trace/scatter_profile.h"

using namespace parhelion;

namespace {

/// Randomly oriented hexagonal prisms.
Cloud freePrisms(double aspect, double index = kIndex) {
  return cloudUnderPointSun(radians(20), {prisms(aspect, RandomOrientation{})}, ConstantIndex{index});
}

/// Sums over rays of the internal path and its square. How many rays are traced at a time differs from run to run, so
/// errors come from single rays.
struct InternalPaths : Film {
  double rays = 0.0, sum = 0.0, squares = 0.0;

  double mean() const { return sum / rays; }
  double standardError() const { return std::sqrt((squares / rays - mean() * mean()) / rays); }

  int add(const TracedRays& traced) override {
    const RayQueue& queue = traced.queue;
    for (int i = 0; i < queue.count; ++i) {
      sum += queue.internalPath[i];
      squares += queue.internalPath[i] * queue.internalPath[i];
    }
    rays += queue.count;
    return traced.exits.count;
  }
  std::unique_ptr<Film> forThread() override { return std::make_unique<InternalPaths>(); }
  void merge(Film& other) override {
    const auto& more = dynamic_cast<InternalPaths&>(other);
    rays += more.rays;
    sum += more.sum;
    squares += more.squares;
  }
};

ScatterProfile::Summary summaryOf(const Cloud& cloud, std::uint64_t rays) {
  ScatterProfile profile(1, 0.0, kPi);
  traceRays(cloud, {.rays = rays}, 0, profile);
  return profile.summary();
}

// Surface and volume of a hexagonal prism with side 1 and length L = 2 aspect.
double prismSurface(double aspect) { return 12.0 * aspect + 3.0 * std::sqrt(3.0); }
double prismVolume(double aspect) { return 3.0 * std::sqrt(3.0) * aspect; }

/// Share of energy, and mean cosine of its scattering angle, where light of a random slab's incidence goes on
/// undeviated or comes back mirrored: what plates tend to as they get thinner.
struct SlabLimit {
  double undeviated = 0.0, g = 0.0;
};
SlabLimit slabLimit(double index) {
  SlabLimit limit;
  constexpr int kSteps = 100'000;
  for (int i = 0; i < kSteps; ++i) {
    const double mu = (i + 0.5) / kSteps;  // cosine of incidence, met in proportion to itself
    const double reflectance = fresnel<double>(mu, index).reflectance;
    const double through = (1.0 - reflectance) / (1.0 + reflectance);  // all inner reflections added up
    limit.undeviated += 2.0 * mu * through / kSteps;
    limit.g += 2.0 * mu * (through + (1.0 - through) * (1.0 - 2.0 * mu * mu)) / kSteps;
  }
  return limit;
}

const PopulationSettings kEveryKind[] = {prisms(0.1, RandomOrientation{}),
                                         prisms(3.0, RandomOrientation{}),
                                         prisms(0.2, AxisOrientation{Normal{0.0, radians(1)}, kFree, kFree}),
                                         {"pyramids", 1.0, PyramidSettings{0.3, 0.9, 0.2}, RandomOrientation{}},
                                         {"mixed", 1.0, PrismSettings{UniformRange{0.05, 5.0}}, RandomOrientation{}}};

}  // namespace

TEST_CASE("every single ray's light leaves, is cut off or is lost, to rounding") {
  for (const PathMode mode : {PathMode::split, PathMode::chance})
    for (const Engine engine : {Engine::embree, Engine::embreeRobust, Engine::planes}) {
      double worst = 0.0, cutOff = 0.0, lost = 0.0;
      const Cloud cloud = cloudUnderPointSun(radians(20), {std::begin(kEveryKind), std::end(kEveryKind)});
      forEachRay(cloud, 100'000,
                 [&](const LightPath& path) {
                   double out = path.cutOff + path.lost;
                   for (const Exit& exit : path.exits) out += exit.energy;
                   worst = std::max(worst, std::abs(out - path.incident.weight));
                   cutOff += path.cutOff;
                   lost += path.lost;
                 },
                 {.engine = engine, .path = mode});
      CHECK(worst < 1e-12);
      CHECK(cutOff == 0.0);
      CHECK(lost == 0.0);
    }
}

TEST_CASE("a run's ledger of energy closes") {
  ScatterProfile profile(180, 0.0, kPi);
  const Cloud cloud = cloudUnderPointSun(radians(20), {std::begin(kEveryKind), std::end(kEveryKind)});
  const TraceReport report = traceRays(cloud, {.rays = 200'000}, 0, profile);
  CHECK(report.rays == 200'000);
  CHECK(std::abs(report.energy.imbalance()) < 1e-10);  // sums are kept to 2^-40 an exit
  double sum = 0.0;
  for (const auto& bin : profile.bins()) sum += bin.energy;
  CHECK(std::abs(sum - 1.0) < 1e-7);  // bins to 2^-29
}

TEST_CASE("the mean shadow of randomly oriented convex crystals is a quarter of their surface (Cauchy)") {
  for (const double aspect : {0.01, 0.1, 1.0, 10.0}) {
    CAPTURE(aspect);
    // Rays come in proportion to the shadow A, so crystals count by 1 / A.
    SampleMean perShadow;
    forEachRay(freePrisms(aspect), 200'000,
               [&](const LightPath& path) { perShadow.add(path.incident.weight / path.incident.shadow); });
    CHECK(perShadow.sigmasFrom(4.0 / prismSurface(aspect)) < 4.0);
    const auto summary = summaryOf(freePrisms(aspect), 200'000);
    const double relativeError = perShadow.standardError() / perShadow.mean();
    CHECK(summary.surface == doctest::Approx(prismSurface(aspect)));
    CHECK(summary.volume == doctest::Approx(prismVolume(aspect)));
    CHECK(std::abs(summary.meanProjectedArea / (prismSurface(aspect) / 4.0) - 1.0) < 4.0 * relativeError);
  }
}

TEST_CASE(
    "randomly oriented crystals of any aspect ratio reflect the same share at their outside, 0.0627420 at n = 1.31") {
  CHECK(std::abs(theory::externalReflection(1.31) - 0.0627420) < 5e-8);
  CHECK(std::abs(theory::externalReflection(1.3110) - 0.0629024) < 5e-8);
  const auto checkReflected = [](double aspect, double index) {
    CAPTURE(index);
    CAPTURE(aspect);
    SampleMean external;
    forEachRay(freePrisms(aspect, index), 500'000, [&](const LightPath& path) {
      external.add(path.exits.front().order == 0 ? path.exits.front().energy : 0.0);
    });
    CHECK(external.sigmasFrom(theory::externalReflection(index)) < 4.0);
  };
  for (const double aspect : {0.01, 0.1, 1.0, 10.0}) checkReflected(aspect, 1.31);
  checkReflected(1.0, 1.3110);
}

TEST_CASE("indices from 1.01 to 3 reflect what they must at the outside, and lose nothing, by all that follows rays") {
  for (const double index : {1.01, 1.2, 1.5, 2.0, 3.0})
    for (const Engine engine : {Engine::planes, Engine::embree}) {
      CAPTURE(index);
      SampleMean external;
      double worst = 0.0, cutOff = 0.0, lost = 0.0;
      forEachRay(freePrisms(0.5, index), 200'000,
                 [&](const LightPath& path) {
                   external.add(path.exits.front().order == 0 ? path.exits.front().energy : 0.0);
                   double out = path.cutOff + path.lost;
                   for (const Exit& exit : path.exits) out += exit.energy;
                   worst = std::max(worst, std::abs(out - path.incident.weight));
                   cutOff += path.cutOff;
                   lost += path.lost;
                 },
                 {.engine = engine});
      CHECK(external.sigmasFrom(theory::externalReflection(index)) < 4.0);
      CHECK(worst < 1e-12);
      CHECK(cutOff == 0.0);
      CHECK(lost == 0.0);
    }
}

TEST_CASE("light stays in prisms for n^2 times the mean chord 4 V / S, energy weighted") {
  struct Case {
    double aspect;
    std::uint64_t rays;
  };
  // Rays enough for 0.2 % to be 4 standard errors. Cutting paths short after ten encounters would lose 1 % and more.
  for (const Case& c : {Case{0.1, 20'000'000}, Case{1.0, 6'000'000}, Case{5.0, 10'000'000}}) {
    CAPTURE(c.aspect);
    InternalPaths paths;
    traceRays(freePrisms(c.aspect), {.rays = c.rays}, 0, paths);
    REQUIRE(paths.rays == static_cast<double>(c.rays));
    const double expected = kIndex * kIndex * 4.0 * prismVolume(c.aspect) / prismSurface(c.aspect);
    CHECK(paths.standardError() < 0.0005 * expected);
    CHECK(std::abs(paths.mean() - expected) < 4.0 * paths.standardError());
    CHECK(std::abs(paths.mean() / expected - 1.0) < 0.002);
  }
}

TEST_CASE("a profile's summary has the mean path and the light of each order that single rays have") {
  const auto summary = summaryOf(freePrisms(1.0), 50'000);
  double intercepted = 0.0, inside = 0.0, second = 0.0;
  forEachRay(freePrisms(1.0), 50'000, [&](const LightPath& path) {
    intercepted += path.incident.weight;
    inside += path.internalPath;
    for (const Exit& exit : path.exits) second += exit.order == 2 ? exit.energy : 0.0;
  });
  CHECK(summary.meanPath == doctest::Approx(inside / intercepted).epsilon(1e-9));
  CHECK(summary.byOrder[2] == doctest::Approx(second / intercepted).epsilon(1e-9));
}

TEST_CASE("plates tend to the slab as they get thinner: undeviated share 0.894049, mean cosine 0.947347") {
  const SlabLimit limit = slabLimit(kIndex);
  CHECK(std::abs(limit.undeviated - 0.894049) < 1e-6);
  CHECK(std::abs(limit.g - 0.947347) < 1e-6);

  struct Shares {
    SampleMean undeviated, g;
  };
  const auto sharesAt = [](double aspect) {
    Shares shares;
    forEachRay(freePrisms(aspect), 700'000, [&](const LightPath& path) {
      double through = 0.0, cosine = 0.0;
      for (const Exit& exit : path.exits) {
        through += exit.undeviated * exit.energy;
        cosine += exit.energy * glm::dot(path.incident.lightDirWorld, exit.lightDirWorld);
      }
      shares.undeviated.add(through);
      shares.g.add(cosine);
    });
    return shares;
  };
  const Shares thin = sharesAt(1e-3), thinner = sharesAt(1e-4);
  // What is missing is the light that meets the rim, in proportion to the aspect ratio; what is left after taking that
  // out goes with its square and is below 1e-5.
  const auto checkLimit = [](const SampleMean& at3, const SampleMean& at4, double expected) {
    const double extrapolated = (10.0 * at4.mean() - at3.mean()) / 9.0;
    const double error = std::hypot(10.0 * at4.standardError(), at3.standardError()) / 9.0;
    CHECK(std::abs(extrapolated - expected) < 4.0 * error + 1e-5);
    CHECK(error < 2e-4);
    CHECK(std::abs(at3.mean() - expected) < 5e-3);
    CHECK((at3.mean() - expected) / (at4.mean() - expected) > 5.0);
  };
  checkLimit(thin.undeviated, thinner.undeviated, limit.undeviated);
  checkLimit(thin.g, thinner.g, limit.g);
}
