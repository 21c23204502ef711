// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <atomic>
#include <cmath>

#include "crystals.h"
#include "trace/expose.h"
#include "trace/scatter_profile.h"
#include "trace/sky_map.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

/// A cloud with everything in it that a scene may ask for: two populations, a spread of aspects, a disc, a spectrum.
Cloud richCloud() {
  AxisOrientation plate;
  plate.zenith = Normal{0.0, radians(1.0)};
  PopulationSettings plates = prismPopulation(0.2, plate), free = prismPopulation(1.0);
  plates.shape = PrismSettings{Normal{0.2, 0.05}};
  const std::vector populations{plates, free};
  return Cloud(SunSettings{}, PublishedIndex{}, populations);
}

/// Level plates under the sun with its disc and spectrum: much of the sky stays dark.
Cloud sunlit() {
  AxisOrientation level;
  const std::vector populations{prismPopulation(0.2, level)};
  return Cloud(SunSettings{}, PublishedIndex{}, populations);
}

Tally emptyTally(const Cloud& cloud) {
  TallyInfo info;
  info.camera.width = info.camera.height = 64;
  info.white = cloud.spectrum().white();
  return Tally(info, cloud.spectrum().colours());
}

Tally tallyOf(const Cloud& cloud, int threads, std::uint64_t firstRay, std::uint64_t endRay) {
  SkyTally tally(emptyTally(cloud));
  const auto film = makeFilm(tally, cloud, Symmetry::none);
  TraceSettings settings;
  settings.rays = endRay;
  TraceControl control;
  control.threads = threads;
  traceRays(cloud, settings, firstRay, *film, control);
  tally.info().rays = {{firstRay, endRay - firstRay}};
  return tally.parts().front().tally;
}

}  // namespace

TEST_CASE("the same seed gives the same bits for one, two and seven threads") {
  const Cloud cloud = richCloud();
  const Tally one = tallyOf(cloud, 1, 0, 60'000);
  CHECK(one == tallyOf(cloud, 2, 0, 60'000));
  CHECK(one == tallyOf(cloud, 7, 0, 60'000));
  CHECK(one.info.intercepted.units() > 0);
  CHECK_FALSE(one == tallyOf(cloud, 1, 0, 59'999));
}

TEST_CASE("profile and map are the same bits for one, two and seven threads") {
  const Cloud cloud = richCloud();
  const auto energies = [&](int threads) {
    ScatterProfile profile(180, 0.0, kPi);
    SkyMap map(cloud.sun().toCentre(), 18);
    TraceSettings settings;
    settings.rays = 40'000;
    TraceControl control;
    control.threads = threads;
    traceRays(cloud, settings, 0, profile, control);
    traceRays(cloud, settings, 0, map, control);
    std::vector<double> all;
    for (const auto& bin : profile.bins()) all.insert(all.end(), {bin.energy, bin.error});
    const auto summary = profile.summary();
    all.insert(all.end(), {summary.g, summary.gError, summary.meanPath, summary.meanProjectedArea, summary.surface});
    for (int row = 0; row < map.rows(); ++row)
      for (int column = 0; column < map.columns(); ++column) all.push_back(map.energy(column, row));
    return all;
  };
  const auto one = energies(1);
  CHECK(one == energies(2));
  CHECK(one == energies(7));
}

TEST_CASE("a run in two parts gives the bits of a run in one") {
  const Cloud cloud = richCloud();
  Tally parts = tallyOf(cloud, 2, 0, 25'000);
  parts.merge(tallyOf(cloud, 1, 25'000, 60'000));
  CHECK(parts == tallyOf(cloud, 2, 0, 60'000));
}

TEST_CASE("another seed gives other rays") {
  const Cloud cloud = richCloud();
  const auto rayOf = [&](std::uint64_t seed) { return RaySource(cloud, {.seed = seed}, 1).ray(7); };
  const IncidentRay a = rayOf(1), b = rayOf(2), again = rayOf(1);
  CHECK(a.lightDirCrystal == again.lightDirCrystal);
  CHECK(a.lightDirCrystal != b.lightDirCrystal);
}

TEST_CASE("a run asked to stop ends with a gapless range of rays and says so") {
  const Cloud cloud = simpleCloud({prismPopulation(1.0)});
  ScatterProfile profile(10, 0.0, kPi);
  TraceSettings settings;
  settings.rays = 1'000'000'000;
  const std::atomic<bool> stop{true};
  TraceControl control;
  control.stop = &stop;
  const TraceReport report = traceRays(cloud, settings, 0, profile, control);
  CHECK(report.interrupted);
  CHECK(report.rays > 0);
  CHECK(report.rays < settings.rays);
  CHECK(profile.summary().rays == report.rays);
}

TEST_CASE("the ledger closes, and a profile over all angles holds all light") {
  const Cloud cloud = richCloud();
  ScatterProfile profile(1800, 0.0, kPi);
  TraceSettings settings;
  settings.rays = 100'000;
  const TraceReport report = traceRays(cloud, settings, 0, profile);
  CHECK(std::abs(report.energy.imbalance()) < 1e-12);
  double sum = 0.0;
  for (const auto& bin : profile.bins()) sum += bin.energy;
  // Each deposit is rounded to 2^-29 of a ray's light.
  CHECK(std::abs(sum - 1.0) < 1e-9);
  const ScatterProfile::Summary summary = profile.summary();
  double byOrder = summary.byOrderRest;
  for (const double energy : summary.byOrder) byOrder += energy;
  CHECK(std::abs(byOrder - 1.0) < 1e-9);
}

TEST_CASE("a summary tells the first orders one by one, and the rest as one") {
  // Thin plates hold light by total reflection for thousands of encounters.
  const Cloud cloud = simpleCloud({prismPopulation(0.01)});
  ScatterProfile one(1, 0.0, kPi);
  constexpr std::uint64_t kRays = 20'000;
  traceRays(cloud, {.rays = kRays}, 0, one);
  const ScatterProfile::Summary summary = one.summary();
  REQUIRE(summary.byOrder.size() == 32);
  double rest = 0.0;
  std::vector<double> byOrder(32, 0.0);
  RaySource source(cloud, {}, 256);
  const Intersectors engines = makeIntersectors(cloud, Engine::planes);
  LightPath path;
  for (std::uint64_t ray = 0; ray < kRays; ++ray) {
    followRay(source, engines, {}, ray, path);
    for (const Exit& exit : path.exits) (exit.order < 32 ? byOrder[exit.order] : rest) += exit.energy / kRays;
  }
  CHECK(rest > 1e-4);
  CHECK(summary.byOrderRest == doctest::Approx(rest).epsilon(1e-4));
  for (int k = 0; k < 32; ++k) CHECK(std::abs(summary.byOrder[k] - byOrder[k]) < 1e-4);
}

TEST_CASE("a bin that nothing hit is not known to be dark: its error is by the rule of three") {
  const Cloud cloud = sunlit();
  for (const std::uint64_t rays : {2'000u, 200'000u}) {
    ScatterProfile profile(1800, 0.0, kPi);
    SkyMap map(cloud.sun().toCentre(), 180);
    traceRays(cloud, {.rays = rays}, 0, profile);
    traceRays(cloud, {.rays = rays}, 0, map);
    const double expected = 3.0 / (static_cast<double>(rays) / 2.0);  // bundles are pairs
    int unhit = 0;
    const auto check = [&](double energy, double error) {
      unhit += energy == 0.0;
      if (energy == 0.0) CHECK(error == doctest::Approx(expected).epsilon(1e-12));
      if (energy > 0.0) CHECK(error > 0.0);
    };
    for (const auto& bin : profile.bins()) check(bin.energy, bin.error);
    for (int row = 0; row < map.rows(); ++row)
      for (int column = 0; column < map.columns(); ++column) check(map.energy(column, row), map.error(column, row));
    CHECK(unhit > 100);
  }
}

TEST_CASE("in the long run bins that a few rays left unhit hold no more than the rule of three says, most of them") {
  const Cloud cloud = sunlit();
  SkyMap few(cloud.sun().toCentre(), 60), many(cloud.sun().toCentre(), 60);
  traceRays(cloud, {.rays = 20'000}, 0, few);
  traceRays(cloud, {.rays = 2'000'000, .seed = 2}, 0, many);
  int unhit = 0, above = 0;
  for (int row = 0; row < few.rows(); ++row)
    for (int column = 0; column < few.columns(); ++column)
      if (few.energy(column, row) == 0.0) {
        ++unhit;
        above += many.energy(column, row) > few.error(column, row);
      }
  CHECK(unhit > 100);
  CHECK(above < 0.05 * unhit);
}

TEST_CASE("undeviated light is in the first bin of a profile and in the sun's bin of a map") {
  const Cloud cloud = simpleCloud({prismPopulation(0.1)}, radians(20.2));
  ScatterProfile profile(18000, 0.0, kPi);
  SkyMap map(cloud.sun().toCentre(), 180);
  TraceSettings settings;
  settings.rays = 50'000;
  traceRays(cloud, settings, 0, profile);
  traceRays(cloud, settings, 0, map);
  const double undeviated = profile.summary().undeviated;
  CHECK(undeviated > 0.6);
  CHECK(profile.bins()[0].energy == doctest::Approx(undeviated).epsilon(0.001));
  CHECK(map.energy(180, 110) == doctest::Approx(undeviated).epsilon(0.001));
  CHECK(degrees(map.azimuth(180)) == doctest::Approx(0.0));
  CHECK(degrees(map.elevation(110)) == doctest::Approx(20.0));
}

TEST_CASE("the stated standard error is the scatter between independent runs") {
  // 400 runs: the variance of a bin over runs is known to 7 %, the mean over 20 bins to 1.6 %; 4 sigma.
  const Cloud cloud = simpleCloud({prismPopulation(1.0)});
  constexpr int kRuns = 400, kBins = 20;
  std::vector<double> sum(kBins), squares(kBins), stated(kBins);
  for (int run = 0; run < kRuns; ++run) {
    ScatterProfile profile(kBins, 0.0, kPi);
    TraceSettings settings;
    settings.seed = 100 + run;
    settings.rays = 1000;
    traceRays(cloud, settings, 0, profile);
    const auto bins = profile.bins();
    for (int i = 0; i < kBins; ++i) {
      sum[i] += bins[i].energy;
      squares[i] += bins[i].energy * bins[i].energy;
      stated[i] += bins[i].error * bins[i].error / kRuns;
    }
  }
  double ratio = 0.0;
  for (int i = 0; i < kBins; ++i) ratio += (squares[i] - sum[i] * sum[i] / kRuns) / (kRuns - 1) / stated[i] / kBins;
  CHECK(ratio == doctest::Approx(1.0).epsilon(0.065).scale(0));
}

TEST_CASE("the two halves of a tally are each half of the light, from different rays") {
  const Tally tally = tallyOf(richCloud(), 2, 0, 60'000);
  double all = 0.0, half = 0.0, apart = 0.0, variance = 0.0;
  for (int pixel = 0; pixel < tally.pixels(); ++pixel) {
    all += tally.luminance(pixel);
    half += tally.firstHalf(pixel);
    const double difference = 2.0 * tally.firstHalf(pixel) - tally.luminance(pixel);
    apart += difference * difference;
    variance += tally.squares(pixel);
  }
  CHECK(half == doctest::Approx(0.5 * all).epsilon(0.03));
  // Independent halves differ by what their scatter says: a sum over some 3000 lit pixels, known to a few per cent.
  CHECK(apart == doctest::Approx(variance).epsilon(0.1));
}
