// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "crystals.h"
#include "trace/wave.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

/// What left a crystal, and all that is known of it.
using Left = std::tuple<double, double, double, double, int, bool>;

/// Everything that waves make of rays, by ray index.
struct Recorder : Film {
  std::map<std::uint64_t, std::vector<Left>> left;
  std::map<std::uint64_t, double> internalPath;

  int add(const TracedRays& traced) override {
    const RayQueue& queue = traced.queue;
    const auto indexOf = [&](int ray) {
      return queue.bundle[queue.placeOf(ray)] * queue.members + static_cast<std::uint64_t>(ray / queue.room);
    };
    for (int i = 0; i < traced.exits.count; ++i) {
      const Vec3 dir = traced.exits.lightDir(i);
      left[indexOf(static_cast<int>(traced.exits.ray[i]))].push_back({dir.x, dir.y, dir.z, traced.exits.energy[i],
                                                                      static_cast<int>(traced.exits.order[i]),
                                                                      traced.exits.undeviated[i] != 0.0});
    }
    for (int member = 0; member < traced.members; ++member)
      for (int place = 0; place < queue.count; ++place) {
        const int ray = queue.ray(member, place);
        internalPath[indexOf(ray)] = queue.internalPath[ray];
      }
    return traced.exits.count;
  }
  std::unique_ptr<Film> forThread() override { return std::make_unique<Recorder>(); }
  void merge(Film& other) override {
    left.merge(dynamic_cast<Recorder&>(other).left);
    internalPath.merge(dynamic_cast<Recorder&>(other).internalPath);
  }
  void sort() {
    for (auto& [index, exits] : left)
      std::sort(exits.begin(), exits.end(),
                [](const Left& a, const Left& b) { return std::get<4>(a) < std::get<4>(b); });
  }
};

Recorder recordWaves(const Cloud& cloud, const TraceSettings& settings, Simd simd = Simd::automatic) {
  Recorder recorder;
  TraceControl control;
  control.simd = simd;
  control.threads = 2;
  traceRays(cloud, settings, 0, recorder, control);
  recorder.sort();
  return recorder;
}

/// Populations of every kind of orientation and shape, under a sun with a disc.
Cloud manyKinds(const SpectrumSettings& spectrum) {
  AxisOrientation tilted, fluttering, wobbling;
  tilted.zenith = Normal{0.0, radians(2.0)};
  fluttering.zenith = Arcsine{radians(90.0), radians(3.0)};
  fluttering.roll = PolarNormal{0.0, radians(1.0)};
  wobbling.zenith = Laplace{0.0, radians(1.0)};
  wobbling.azimuth = FixedValue{radians(40.0)};
  PopulationSettings plates = prismPopulation(0.2, tilted), spread = prismPopulation(1.0, wobbling);
  spread.shape = PrismSettings{Normal{0.5, 0.2}};
  const std::vector<PopulationSettings> kinds{plates,
                                              spread,
                                              prismPopulation(2.0, fluttering),
                                              prismPopulation(0.3, LowitzOrientation{}),
                                              {"pyramids", 0.5, PyramidSettings{0.4, 0.5, 0.8}, RandomOrientation{}}};
  SunSettings sun;
  sun.spectrum = spectrum;
  return Cloud(sun, PublishedIndex{}, kinds);
}

/// Where the first ray differs, or nothing.
void checkSame(const Recorder& a, const Recorder& b) {
  REQUIRE(a.left.size() == b.left.size());
  CHECK(a.left == b.left);
  CHECK(a.internalPath == b.internalPath);
}

}  // namespace

TEST_CASE("waves make of every ray, to the last bit, what following it alone makes of it") {
  for (const SpectrumSettings& spectrum : std::vector<SpectrumSettings>{
           ContinuousSpectrum{}, LineSpectrum{{450.0, 550.0, 650.0}}, MonochromaticSpectrum{550.0}})
    for (const PathMode path : {PathMode::split, PathMode::chance})
      for (const Engine engine : {Engine::planes, Engine::embree}) {
        TraceSettings settings;
        settings.rays = 10'001;  // the last bundle of three is cut short
        settings.path = path;
        settings.engine = engine;
        const Cloud cloud = manyKinds(spectrum);
        const Recorder waves = recordWaves(cloud, settings);
        const Intersectors engines = makeIntersectors(cloud, engine);
        RaySource source(cloud, settings, 100);
        LightPath alone;
        for (std::uint64_t index = 0; index < settings.rays; ++index) {
          followRay(source, engines, settings, index, alone);
          std::vector<Left> expected;
          for (const Exit& exit : alone.exits)
            expected.push_back({exit.lightDirWorld.x, exit.lightDirWorld.y, exit.lightDirWorld.z, exit.energy,
                                exit.order, exit.undeviated});
          REQUIRE(waves.left.at(index) == expected);
          REQUIRE(waves.internalPath.at(index) == alone.internalPath);
        }
        CHECK(waves.internalPath.size() == settings.rays);
      }
}

TEST_CASE("vector registers of every width give the same bits") {
  for (const Sampler sampler : {Sampler::random, Sampler::sobol}) {
    TraceSettings settings;
    settings.rays = 100'000;
    settings.sampler = sampler;
    const Cloud cloud = manyKinds(ContinuousSpectrum{});
    const Recorder baseline = recordWaves(cloud, settings, Simd::baseline);
    CHECK(baseline.left.size() == settings.rays);
    for (const Simd simd : simdHere()) checkSame(baseline, recordWaves(cloud, settings, simd));
  }
}
