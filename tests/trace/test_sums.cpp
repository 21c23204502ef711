// SPDX-License-Identifier: Apache-2.0
// What a run adds up, at the extremes that scene files may ask for.
#include <doctest/doctest.h>

#include <cmath>
#include <stdexcept>

#include "skies.h"
#include "trace/scatter_profile.h"
#include "trace/sky_map.h"
#include "trace/tracer.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

/// Mean and standard error of the internal path, ray by ray in plain doubles.
struct PathStatistics {
  double mean, error;
};
PathStatistics pathStatistics(const Cloud& cloud, const TraceSettings& settings) {
  RaySource source(cloud, settings, 256);
  const Intersectors engines = makeIntersectors(cloud, settings.engine);
  LightPath path;
  double sum = 0.0, squares = 0.0, light = 0.0;
  for (std::uint64_t ray = 0; ray < settings.rays; ++ray) {
    followRay(source, engines, settings, ray, path);
    sum += path.internalPath;
    squares += path.internalPath * path.internalPath;
    light += path.incident.weight;
  }
  return {sum / light, std::sqrt(squares - sum * sum / static_cast<double>(settings.rays)) / light};
}

}  // namespace

TEST_CASE("mean path and its standard error are those of the rays, from the thinnest plates to the longest columns") {
  for (const double aspect : {kThinnestAspect, 1e-3, 1.0, 1000.0, 3000.0, kLongestAspect})
    for (const PopulationSettings& population :
         {prismPopulation(aspect), PopulationSettings{"bullets", 1.0, PyramidSettings{0.9 * aspect, 0.5, 0.0}}}) {
      CAPTURE(aspect);
      const Cloud cloud = simpleCloud({population});
      const TraceSettings settings{.rays = 20'000, .engine = Engine::planes};
      ScatterProfile profile(1, 0.0, kPi);
      traceRays(cloud, settings, 0, profile);
      const PathStatistics expected = pathStatistics(cloud, settings);
      const ScatterProfile::Summary summary = profile.summary();
      // Sums round each ray's path and its square to 2^-40.
      CHECK(summary.meanPath == doctest::Approx(expected.mean).epsilon(1e-10));
      CHECK(summary.meanPathError == doctest::Approx(expected.error).epsilon(1e-8));
      CHECK(summary.surface > 0.0);
      CHECK(summary.volume > 0.0);
      CHECK(summary.meanProjectedArea > 0.0);
    }
}

TEST_CASE("the ledger closes for rays of very different weights") {
  // Sobol' rays weigh what their crystal intercepts over the mean. Of upright columns under the zenith's sun whose
  // aspects are spread to the limits, the thinnest weigh more than 2000.
  PopulationSettings columns = prismPopulation(1.0, AxisOrientation{});
  columns.shape = PrismSettings{UniformRange{kThinnestAspect, kLongestAspect}};
  const Cloud cloud = simpleCloud({columns}, 0.5 * kPi);
  const TraceSettings settings{.rays = 200'000, .sampler = Sampler::sobol};
  double highest = 0.0;
  RaySource source(cloud, settings, 256);
  for (std::uint64_t ray = 0; ray < settings.rays; ++ray) highest = std::max(highest, source.ray(ray).weight);
  CHECK(highest > 1500.0);
  CHECK(highest <= cloud.incidence(0, Sampler::sobol).highestWeight());
  SkyMap map(cloud.sun().toCentre(), 2);
  const TraceReport report = traceRays(cloud, settings, 0, map);
  CHECK(std::abs(report.energy.imbalance()) < 1e-12);
}

TEST_CASE("no ray weighs more than the most that its population says") {
  for (const View& view : {View{sunlit({plates(), lowitzPlates(), pyramids(0.9, 0.2)}), wholeSphere()},
                           View{simpleCloud({prismPopulation(1e-4, AxisOrientation{})}, 0.0), wholeSphere()}})
    for (const Sampler sampler : kMembersOf<Sampler>) {
      RaySource source(view.cloud, {.sampler = sampler}, 256);
      for (std::uint64_t ray = 0; ray < 5000; ++ray) {
        const IncidentRay drawn = source.ray(ray);
        REQUIRE(drawn.weight <= view.cloud.incidence(drawn.population, sampler).highestWeight());
      }
    }
}

TEST_CASE("a bin holds the squares of large bundles, however many") {
  BundleBins bins(1), all(1);
  BundleDeposits<double> bundle;
  for (int i = 0; i < 4; ++i) {  // bundles that bring 0 and 1000 in turn
    bundle.clear();
    if (i % 2 == 1) bundle.add(0, 1000.0);
    bins.add(bundle);
  }
  constexpr int kDoublings = 20;  // 1e6 bundles of which half bring a square of 1e6: 3.5e19 units of 2^-26
  all.merge(bins);
  for (int i = 0; i < kDoublings; ++i) all.merge(BundleBins(all));
  const double bundles = 4.0 * (1 << kDoublings);
  CHECK(all.light(0) == 500.0 * bundles);
  CHECK(all.error(0, static_cast<std::uint64_t>(bundles)) == doctest::Approx(500.0 * std::sqrt(bundles)).epsilon(1e-9));
  CHECK_THROWS_AS(
      [&] {
        for (int i = 0; i < 5; ++i) all.merge(BundleBins(all));
      }(),
      std::overflow_error);
}

TEST_CASE("without the result, films say how full it will be at most, and not much more") {
  // A narrow picture of odd width, whose middle column holds both images; and rings, of which a pixel holds many.
  for (const auto& population : {plates(), prismPopulation(1.0)}) {
    const Cloud cloud = sunlit({population});
    TallyInfo info;
    info.camera = lookAt(Projection::rectilinear, 0.0, 20.0, 0.0, 60.0, 3, 3);
    info.white = cloud.spectrum().white();
    info.sunElevation = std::asin(cloud.sun().toCentre().z);
    SkyTally tally(info, 3, different(symmetriesOf(cloud, Symmetry::automatic)));
    const auto film = makeFilm(tally, cloud, Symmetry::automatic);
    const TraceSettings settings = by(Symmetry::automatic, 20'000, 3);
    Tracer tracer(cloud, settings, *film, 2);
    tracer.trace({0, settings.rays}, [](std::uint64_t) { return true; });
    tracer.collect();
    const double most = film->fullnessAtMost();
    film->finish();
    CHECK(film->fullness() > 0.0);
    CHECK(film->fullness() <= most);
    CHECK(most <= 100.0 * film->fullness());  // much of the light is out of view
    CHECK(film->fullnessAtMost() >= film->fullness());
  }
}
