// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <doctest/doctest.h>

#include "crystals.h"
#include "trace/path_plan.h"
#include "trace/scatter_profile.h"
#include "trace/trace.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

/// The last light to leave by a path, and what the pool says of that.
struct Path {
  PathCode::Words words;
  double state = 0.0, energy = 0.0;

  bool operator==(const Path&) const = default;
};

/// By ray and by order: a ray leaves at each encounter once at the most.
using Paths = std::map<std::pair<std::uint64_t, int>, Path>;

/// What the pool says of the paths of all exits.
struct SequenceFilm : Film {
  Paths paths;

  bool wantsSequences() const override { return true; }
  int add(const TracedRays& traced) override {
    const ExitList& exits = traced.exits;
    for (int i = 0; i < exits.count; ++i) {
      const int ray = static_cast<int>(exits.ray[i]);
      const std::uint64_t index =
          traced.queue.bundle[traced.queue.placeOf(ray)] * static_cast<std::uint64_t>(traced.queue.members) +
          static_cast<std::uint64_t>(traced.queue.memberOf(ray));
      paths[{index, static_cast<int>(exits.order[i])}] = {
          {exits.pathFirst[i], exits.pathLast[i]}, exits.pathState[i], exits.energy[i]};
    }
    return exits.count;
  }
  std::unique_ptr<Film> forThread() override { return std::make_unique<SequenceFilm>(); }
  void merge(Film& other) override { paths.merge(dynamic_cast<SequenceFilm&>(other).paths); }
};

/// The same of rays that are followed one by one.
Paths pathsOfSingleRays(const Cloud& cloud, const TraceSettings& settings, std::uint64_t first) {
  const PathPlan plan(cloud, settings.paths, true);
  const Intersectors engines = makeIntersectors(cloud, settings.engine);
  RaySource source(cloud, settings, 1024);
  Paths paths;
  LightPath path;
  path.recordEncounters = true;
  for (std::uint64_t ray = first; ray < settings.rays; ++ray) {
    followRay(source, engines, settings, ray, path);
    const int population = path.incident.population;
    const auto& faces = cloud.populations()[population].mesh().faces();
    PathCode::Words words;
    int state = PathAutomaton::kStart, count = 0;
    for (const Encounter& met : path.encounters) {
      const auto face = std::ranges::find(faces, met.faceNumber, &Face::number) - faces.begin();
      state = plan.automaton(population).next(state, static_cast<int>(face));
      words = plan.code(population).with(words, static_cast<int>(face), count++);
      if (met.energyLeaving > 0.0) paths[{ray, met.order}] = {words, static_cast<double>(state), met.energyLeaving};
    }
  }
  return paths;
}

/// Plates, columns, Lowitz plates and pyramids under a point sun of one wavelength.
Cloud everyKind() {
  return simpleCloud({prismPopulation(0.2, AxisOrientation{Normal{0.0, radians(2)}}),
                      prismPopulation(3.0, AxisOrientation{Normal{0.5 * kPi, radians(1)}}),
                      prismPopulation(0.3, LowitzOrientation{}),
                      {"pyramids", 0.5, PyramidSettings{0.4, 0.5, 0.8}, RandomOrientation{}}});
}

LayerSettings layer(const std::string& pattern) { return {pattern, parsePathPattern(pattern), {}, {}}; }

PathSettings someLayers() {
  return {{}, {layer("3-5"), layer("1-3 | 3-1"), layer("*-basal-*, hits = 3..9"), layer("exit = pyramid")}};
}

void checkSequences(const TraceSettings& settings, const Cloud& cloud, std::uint64_t first, Simd simd, int threads) {
  SequenceFilm film;
  TraceControl control;
  control.threads = threads;
  control.simd = simd;
  traceRays(cloud, settings, first, film, control);
  const Paths expected = pathsOfSingleRays(cloud, settings, first);
  CHECK(film.paths.size() >= settings.rays - first);
  CHECK((film.paths == expected));
}

std::vector<ScatterProfile::Bin> profileOf(const Cloud& cloud, const TraceSettings& settings,
                                           TraceReport* report = {}) {
  ScatterProfile profile(180, 0.0, kPi);
  const TraceReport own = traceRays(cloud, settings, 0, profile);
  if (report) *report = own;
  return profile.bins();
}

}  // namespace

TEST_CASE("the pool and single rays agree on the faces of a million rays' paths, and on the automaton's state") {
  const Cloud cloud = everyKind();
  constexpr std::uint64_t kRays = 1'000'000, kAtATime = 100'000;
  for (std::uint64_t first = 0; first < kRays; first += kAtATime)
    checkSequences({.rays = first + kAtATime, .paths = someLayers()}, cloud, first, Simd::automatic, 2);
}

TEST_CASE("paths are the same for all registers, engines, modes and numbers of threads") {
  const Cloud cloud = everyKind();
  for (const Simd simd : simdHere())
    for (const Engine engine : {Engine::planes, Engine::embree})
      for (const PathMode mode : {PathMode::split, PathMode::chance})
        for (const int threads : {1, 7})
          checkSequences({.rays = 4'000, .engine = engine, .path = mode, .paths = someLayers()}, cloud, 0, simd,
                         threads);
}

TEST_CASE("a filter that takes everything changes no bit, and one and its opposite add up to all") {
  const Cloud cloud = everyKind();
  const auto by = [](std::optional<PathPattern> filter) {
    return TraceSettings{.rays = 50'000, .paths = {std::move(filter), {}}};
  };
  TraceReport plainReport, someReport, otherReport;
  const auto plain = profileOf(cloud, by({}), &plainReport), every = profileOf(cloud, by(anyPath()));
  const auto some = profileOf(cloud, by(parsePathPattern("3-5 | 1-3")), &someReport);
  const auto others = profileOf(cloud, by(parsePathPattern("not 3-5 | 1-3")), &otherReport);
  for (std::size_t i = 0; i < plain.size(); ++i) {
    CHECK(every[i].energy == plain[i].energy);
    CHECK(every[i].error == plain[i].error);
    CHECK(some[i].energy + others[i].energy == doctest::Approx(plain[i].energy).epsilon(1e-6));
    // Light that is deviated by less than the 60 degree wedge's least has not passed 3-5 or 1-3.
    if (plain[i].to < radians(21.0)) CHECK(some[i].energy == 0.0);
  }
  CHECK(someReport.energy.filtered.value() > 0.0);
  CHECK(std::abs(someReport.energy.imbalance()) < 1e-10);
  CHECK(someReport.energy.filtered.units() + otherReport.energy.filtered.units() == plainReport.energy.out.units());
  CHECK(someReport.deposits + otherReport.deposits == plainReport.deposits);
}

TEST_CASE("patterns speak of the populations and stances that they name") {
  const Cloud cloud = simpleCloud({{"a", 1.0, PrismSettings{FixedValue{0.2}}, AxisOrientation{Normal{0.0, radians(1)}}},
                                   {"b", 1.0, PrismSettings{FixedValue{2.0}}, RandomOrientation{}}});
  const PathPlan plan(cloud, {{}, {layer("3-5, population = b"), layer("circumzenithal arc"), {"c", {}, {"b"}, {}}}});
  const auto layerOf = [&](int population, std::vector<int> faces) {
    int state = PathAutomaton::kStart;
    for (const int face : faces) state = plan.automaton(population).next(state, face - 1);
    return plan.layerOf(population, state, ~std::uint64_t{0});
  };
  CHECK(layerOf(0, {3, 5}) == 3);
  CHECK(layerOf(1, {3, 5}) == 0);
  CHECK(layerOf(0, {1, 3}) == 1);
  CHECK(layerOf(1, {1, 3}) == 2);
  CHECK(layerOf(0, {2, 3}) == 3);
}

TEST_CASE("layers of tilt part the crystals by how far they are from their rest") {
  const auto tilted = [](double zenith) { return Vec3(std::sin(zenith), 0.0, std::cos(zenith)); };
  struct Case {
    OrientationSettings orientation;
    double rest;  // zenith angle
    bool ofCrystalY;
  };
  const Case cases[] = {
      {AxisOrientation{Normal{0.0, 0.1}}, 0.0, false},  {AxisOrientation{Normal{0.5 * kPi, 0.1}}, 0.5 * kPi, false},
      {AxisOrientation{Normal{-0.4, 0.1}}, 0.4, false}, {AxisOrientation{Normal{kPi, 0.1}}, kPi, false},
      {LowitzOrientation{}, 0.5 * kPi, true},           {RandomOrientation{}, 0.0, false},
  };
  using Range = LayerSettings::TiltRange;
  const PathSettings settings{
      {}, {{"low", {}, {}, Range{0.0, 0.05}}, {"high", {}, {}, Range{0.05, 0.7}}, {"far", {}, {}, Range{0.7, kPi}}}};
  for (const auto& [orientation, rest, ofCrystalY] : cases) {
    CAPTURE(rest);
    const Cloud cloud = simpleCloud({prismPopulation(0.2, orientation)});
    const PathPlan plan(cloud, settings);
    CHECK(plan.hasTilts(0));
    int wrong = 0;
    for (int i = 0; i < 1000; ++i) {
      const double zenith = kPi * (i + 0.5) / 1000.0, tilt = std::abs(zenith - rest);
      const Vec3 axis = tilted(zenith), none(0.0, 0.0, -1.0);
      const auto allowed = plan.layersFor(0, ofCrystalY ? axis : none, ofCrystalY ? none : axis);
      const int layer = plan.layerOf(0, plan.automaton(0).next(PathAutomaton::kStart, 0), allowed);
      wrong += layer != (tilt < 0.05 ? 0 : tilt < 0.7 ? 1 : 2);
    }
    CHECK(wrong == 0);
  }
  const Cloud cloud = simpleCloud({prismPopulation(0.2, AxisOrientation{})});
  CHECK_FALSE(PathPlan(cloud, {{}, {{"all", {}, {}, {}}}}).hasTilts(0));
}
