// SPDX-License-Identifier: Apache-2.0
// Light that is scattered more than once in a slab: fluxes, energy, order sums.
#include "trace/trace_orders.h"

#include <atomic>
#include <cmath>

#include <doctest/doctest.h>

#include "adding_doubling.h"
#include "crystal/objs.h"
#include "crystals.h"
#include "math/rotation.h"
#include "statistics.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

/// Keeps nothing.
class NoFilm : public Film {
 public:
  int add(const TracedRays&) override { return 0; }
  std::unique_ptr<Film> forThread() override { return std::make_unique<NoFilm>(); }
  void merge(Film&) override {}
};

/// Adds up what is deposited above and below the horizon times the sine of its elevation, and how much of it comes from
/// within 2 degrees of the horizon, with the squares.
class FluxFilm : public Film {
 public:
  int add(const TracedRays& traced) override {
    for (int i = 0; i < traced.exits.count; ++i) {
      const auto exit = static_cast<std::size_t>(i);
      if (traced.exits.undeviated[exit] != 0.0) continue;
      const double z = traced.exits.lightDir(i).z, light = traced.exits.energy[exit];
      (z > 0.0 ? up : down) += light * std::abs(z);
      if (std::abs(z) > std::sin(radians(2.0))) continue;
      level += light;
      squares += light * light;
    }
    return 0;
  }
  std::unique_ptr<Film> forThread() override { return std::make_unique<FluxFilm>(); }
  void merge(Film& other) override {
    const auto& film = dynamic_cast<FluxFilm&>(other);
    up += film.up;
    down += film.down;
    level += film.level;
    squares += film.squares;
  }

  double up = 0.0, down = 0.0, level = 0.0, squares = 0.0;
};

SlabContents under(double elevation) {
  SlabContents contents;
  contents.sun.elevation = radians(elevation);
  contents.sun.diameter = 0.0;
  contents.sun.spectrum = MonochromaticSpectrum{550.0};
  contents.ice = ConstantIndex{1.31};
  return contents;
}

OrderReport walksThrough(const SlabContents& contents, const SlabSettings& slab, std::uint64_t walks, Film& film,
                         std::uint64_t seed = 3) {
  const Extinction extinction(contents.sun, contents.ice, contents.populations, contents.hazes);
  const SlabStack stack(extinction, contents.populations, contents.hazes, slab);
  const ManyOrders orders(contents, slab.orders, stack, Engine::automatic);
  TraceControl control;
  control.threads = 2;
  return traceOrders(orders, walks, TraceSettings{.seed = seed}, {}, film, control);
}

OrderLedger energyOf(const SlabContents& contents, const SlabSettings& slab, std::uint64_t walks,
                     std::uint64_t seed = 3) {
  NoFilm none;
  return walksThrough(contents, slab, walks, none, seed).energy;
}

SlabContents hazeUnder(double elevation, double g) {
  SlabContents contents = under(elevation);
  contents.hazes.push_back({"haze", 1.0, HenyeyGreenstein{g}});
  return contents;
}

SlabContents crystalsUnder(double elevation, const std::vector<PopulationSettings>& populations) {
  SlabContents contents = under(elevation);
  contents.populations = populations;
  return contents;
}

constexpr int kAll = SlabSettings::kAllOrders;

}  // namespace

TEST_CASE("adding and doubling has the known flux through an isotropic slab of depth 1") {
  // Between black walls, as tables of radiative transfer have it: 0.5532 to 0.5534.
  const SlabFlux flux = AddingDoubling(0.0, 1.0, 0.5).diffuse();
  CHECK(flux.transmitted == doctest::Approx(0.5534).epsilon(5e-4));
  CHECK(flux.reflected + flux.transmitted == doctest::Approx(1.0).epsilon(1e-5));
}

TEST_CASE("haze reflects and transmits as adding and doubling has it, within 0.5 % of the light that falls on it") {
  // No less than 2.9 standard errors of any case.
  constexpr double kWithin = 0.005, kMostError = kWithin / 2.9;
  constexpr int kRuns = 8;
  for (const double g : {0.0, 0.75, 0.85})
    for (const double depth : {0.5, 1.0, 2.0, 8.0}) {
      CAPTURE(g);
      CAPTURE(depth);
      const double elevation = depth == 1.0 ? 60.0 : 20.0;
      const SlabFlux exact = AddingDoubling(g, depth, std::sin(radians(elevation))).ofSun();
      SampleMean up, down;
      for (int run = 0; run < kRuns; ++run) {
        const OrderLedger walked = energyOf(hazeUnder(elevation, g), {depth, kAll}, 10'000, 3 + run);
        up.add(walked.reflected());
        down.add(walked.transmitted());
      }
      CHECK(std::abs(up.mean() - exact.reflected) < kSigmas * up.standardError());
      CHECK(std::abs(down.mean() - exact.transmitted) < kSigmas * down.standardError());
      CHECK(up.standardError() < kMostError);
      CHECK(std::abs(up.mean() - exact.reflected) < kWithin);
      CHECK(std::abs(down.mean() - exact.transmitted) < kWithin);
    }
}

TEST_CASE("what falls on a cloud leaves it above or below, order by order, to 1e-9") {
  const std::vector<PopulationSettings> plates{prismPopulation(0.2, AxisOrientation{Normal{0.0, radians(2.0)}})};
  for (const double depth : {0.01, 1.0, 50.0})
    for (const int orders : {1, 3, kAll}) {
      CAPTURE(depth);
      CAPTURE(orders);
      SlabContents mixed = crystalsUnder(20.0, plates);
      mixed.populations.push_back(prismPopulation(1.0));
      mixed.hazes.push_back({"haze", 0.5, HenyeyGreenstein{0.8}});
      const OrderLedger energy = energyOf(mixed, {depth, orders}, depth > 10.0 ? 5000 : 20000);
      CHECK(std::abs(energy.imbalance()) < 1e-9);
      CHECK(energy.cutOff.value() < 1e-3 * energy.in.value());
      if (orders == kAll) CHECK(energy.leftOut.value() == 0.0);
      if (orders != kAll) CHECK(energy.leftOut.value() > 0.0);
      if (orders == 1) CHECK(energy.below[1].value() == 0.0);
    }
}

TEST_CASE("what is deposited times the sine of its elevation is what leaves the cloud, above and below") {
  SlabContents mixed = crystalsUnder(25.0, {prismPopulation(0.2, AxisOrientation{Normal{0.0, radians(2.0)}})});
  mixed.hazes.push_back({"haze", 0.5, HenyeyGreenstein{0.8}});
  const std::vector<std::string> all{mixed.populations[0].name, "haze"}, crystals{mixed.populations[0].name};
  for (const SlabSettings& slab : {SlabSettings{1.0, kAll}, SlabSettings{0.2, 3},
                                   SlabSettings{2.0, kAll, {{all, 0.5}, {crystals, 1.0}, {{"haze"}, 0.5}}}}) {
    CAPTURE(slab.opticalDepth);
    CAPTURE(slab.layers.size());
    SampleMean up, down;
    for (int run = 0; run < 16; ++run) {
      FluxFilm film;
      const OrderLedger energy = walksThrough(mixed, slab, 6000, film, 3 + run).energy;
      const auto more = [](const auto& orders) {
        double sum = 0.0;
        for (std::size_t k = 1; k < orders.size(); ++k) sum += orders[k].value();
        return sum;
      };
      up.add((film.up - more(energy.above)) / energy.in.value());
      down.add((film.down - more(energy.below)) / energy.in.value());
    }
    for (const SampleMean& difference : {up, down}) {
      CHECK(std::abs(difference.mean()) < kSigmas * difference.standardError());
      CHECK(difference.standardError() < 0.002);
    }
  }
}

TEST_CASE("walks that are stopped leave a whole account of those that were done") {
  const SlabContents haze = hazeUnder(25.0, 0.5);
  const Extinction extinction(haze.sun, haze.ice, haze.populations, haze.hazes);
  const SlabSettings slab{1.0, kAll};
  const SlabStack stack(extinction, haze.populations, haze.hazes, slab);
  const ManyOrders orders(haze, slab.orders, stack, Engine::automatic);
  std::atomic<bool> stop = true;
  TraceControl control;
  control.stop = &stop;
  std::uint64_t told = 0;
  control.onProgress = [&](std::uint64_t done, double) { told = done; };
  FluxFilm film;
  const OrderReport report = traceOrders(orders, 50'000, {}, {}, film, control);
  CHECK(report.interrupted);
  CHECK(report.walks > 0);
  CHECK(report.walks < 50'000);
  CHECK(told == report.walks);
  CHECK(report.energy.in.value() == doctest::Approx(static_cast<double>(report.walks)).epsilon(1e-9));
  CHECK(std::abs(report.energy.imbalance()) < 1e-9);
  stop = false;
  CHECK_FALSE(traceOrders(orders, 50'000, {}, {}, film, control).interrupted);
}

TEST_CASE("light along the horizon comes in many small deposits, not in few large ones") {
  FluxFilm film;
  walksThrough(hazeUnder(25.0, 0.0), {1.0, kAll}, 20'000, film);
  // The number of equal deposits that would scatter as much.
  CHECK(film.level * film.level / film.squares > 1000.0);
}

TEST_CASE("the direct beam of random columns at depth 1 and sun 20 is 0.108") {
  const OrderLedger energy = energyOf(crystalsUnder(20.0, {prismPopulation(1.0)}), {1.0, 2}, 1000);
  CHECK(energy.direct.value() / energy.in.value() == doctest::Approx(0.1084).epsilon(5e-3));
}

TEST_CASE("two layers of the same crystals scatter as one of the summed depth, order by order") {
  SlabContents mixed = crystalsUnder(25.0, {prismPopulation(0.2, AxisOrientation{Normal{0.0, radians(2.0)}})});
  mixed.hazes.push_back({"haze", 0.5, HenyeyGreenstein{0.8}});
  const std::vector<std::string> names{mixed.populations[0].name, "haze"};
  SampleMean differences[4];
  for (int run = 0; run < 8; ++run) {
    const OrderLedger one = energyOf(mixed, {1.0, kAll}, 6000, 3 + run),
                      two = energyOf(mixed, {1.0, kAll, {{names, 0.3}, {names, 0.7}}}, 6000, 103 + run);
    CHECK(two.direct.value() / two.in.value() == doctest::Approx(one.direct.value() / one.in.value()).epsilon(1e-6));
    const double n = one.in.value();
    differences[0].add((one.above[0].value() - two.above[0].value()) / n);
    differences[1].add((one.below[0].value() - two.below[0].value()) / n);
    differences[2].add((one.above[1].value() - two.above[1].value()) / n);
    differences[3].add(one.transmitted() - two.transmitted());
  }
  for (const SampleMean& difference : differences) {
    CHECK(std::abs(difference.mean()) < kSigmas * difference.standardError());
    CHECK(difference.standardError() < 0.005);
  }
}

TEST_CASE("of two layers the upper one sends more light up than it does as the lower one, and nothing is lost") {
  SlabContents hazes = under(40.0);
  hazes.hazes = {{"back", 1.0, HenyeyGreenstein{-0.5}}, {"forth", 1.0, HenyeyGreenstein{0.9}}};
  const SlabLayer back{{"back"}, 0.5}, forth{{"forth"}, 2.0};
  for (const int orders : {1, 3, kAll}) {
    CAPTURE(orders);
    const OrderLedger upper = energyOf(hazes, {2.5, orders, {back, forth}}, 20'000),
                      lower = energyOf(hazes, {2.5, orders, {forth, back}}, 20'000);
    CHECK(upper.above[0].value() > 2.0 * lower.above[0].value());
    CHECK(std::abs(upper.imbalance()) < 1e-9);
    CHECK(std::abs(lower.imbalance()) < 1e-9);
    CHECK(upper.direct.value() == doctest::Approx(lower.direct.value()).epsilon(1e-9));
  }
}

TEST_CASE("crystals that absorb take light at every scattering, and the energy of all walks closes") {
  SlabContents contents = crystalsUnder(30.0, {prismPopulation(1.0)});
  contents.hazes.push_back({"haze", 1e-3, HenyeyGreenstein{0.8}});
  contents.populations[0].size = FixedValue{200.0};
  contents.ice.absorbs = true;
  contents.ice.k = 1e-4;
  const OrderLedger energy = energyOf(contents, {2.0, kAll, {}}, 20'000);
  CHECK(std::abs(energy.imbalance()) < 1e-9);
  CHECK(energy.absorbed.value() > 0.1 * energy.in.value());
  contents.ice.k = 0.0;
  const OrderLedger bright = energyOf(contents, {2.0, kAll, {}}, 20'000);
  CHECK(bright.absorbed.value() == 0.0);
  CHECK(bright.reflected() > energy.reflected());
}

TEST_CASE("light that crystals scatter which are not convex leaves the cloud above or below, order by order, to 1e-9") {
  PrismSettings hollow{FixedValue{1.0}};
  hollow.upper.cavity = hollow.lower.cavity = {0.5, 0.8};
  PopulationSettings columns, rosettes;
  columns.shape = hollow;
  columns.orientation = AxisOrientation{Normal{0.5 * kPi, radians(2.0)}};
  rosettes.shape = RosetteSettings{6, 1.0};
  rosettes.name = "rosettes";
  for (const int orders : {1, 3, kAll}) {
    CAPTURE(orders);
    SlabContents mixed = crystalsUnder(20.0, {columns, rosettes, prismPopulation(1.0)});
    mixed.hazes.push_back({"haze", 0.5, HenyeyGreenstein{0.8}});
    const OrderLedger energy = energyOf(mixed, {1.0, orders}, 5000);
    CHECK(std::abs(energy.imbalance()) < 1e-9);
    CHECK(energy.cutOff.value() < 1e-3 * energy.in.value());
    if (orders == kAll) CHECK(energy.leftOut.value() == 0.0);
    if (orders == 1) CHECK(energy.below[1].value() == 0.0);
  }
}

TEST_CASE("a convex crystal that is followed as one that is not scatters alike in a cloud, order by order") {
  const PyramidSettings pyramid{0.4, 0.7, 0.2};
  PopulationSettings own, triangles;
  own.shape = pyramid;
  triangles.shape = asTriangles(meshOf(pyramid));
  own.orientation = triangles.orientation = AxisOrientation{Normal{0.0, radians(3.0)}};
  // Another kind beside it, of which there would be more if bounds or silhouettes were wrong.
  const PopulationSettings others = prismPopulation(0.1, AxisOrientation{Normal{0.0, radians(1.0)}});
  SampleMean differences[5];
  for (int run = 0; run < 8; ++run) {
    const OrderLedger a = energyOf(crystalsUnder(25.0, {own, others}), {1.0, kAll}, 4000, 3 + run),
                      b = energyOf(crystalsUnder(25.0, {triangles, others}), {1.0, kAll}, 4000, 103 + run);
    const double n = a.in.value();
    for (std::size_t k = 0; k < 2; ++k) {
      differences[2 * k].add((a.above[k].value() - b.above[k].value()) / n);
      differences[2 * k + 1].add((a.below[k].value() - b.below[k].value()) / n);
    }
    differences[4].add(a.transmitted() - b.transmitted());
  }
  for (const SampleMean& difference : differences) {
    CHECK(std::abs(difference.mean()) < kSigmas * difference.standardError());
    CHECK(difference.standardError() < 0.005);
  }
}
