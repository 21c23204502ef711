// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <atomic>
#include <cstdio>
#include <utility>

#include "hit_maps.h"
#include "recon/methods.h"

namespace parhelion {
namespace {

MethodOnMap marvastiWith(const MarvastiSettings& settings) {
  return [settings](const HitMap& map) { return reconstructHits(map, settings, {}); };
}

}  // namespace

TEST_CASE("Marvasti's filter leaves a constant sky constant up to its border, with and without iterations") {
  for (const double period : {1.0, 4.0, 17.0, 500.0}) {
    CHECK(errorOfConstantSky(marvastiWith({period, 0, 1.0})) < 1e-9);
    CHECK(errorOfConstantSky(marvastiWith({period, 3, 1.0})) < 1e-9);
  }
}

TEST_CASE("Marvasti's filter bears empty maps, single hits, piles and holes") { checkAwkwardMaps(marvastiWith({})); }

TEST_CASE("Marvasti's filter gives the same bits for any number of threads and filters all lights alike") {
  checkThreadsAndLights(marvastiWith({{}, 2, 1.0}));
}

TEST_CASE("without iterations Marvasti's filter keeps the light, round a torus all of it") {
  CHECK(gain(marvastiWith({8.0, 0, 1.0}), poissonHits(emptySky(128, 128, true), 0.1, 3)) ==
        doctest::Approx(1.0).epsilon(1e-9));
  CHECK(gain(marvastiWith({}), poissonHits(emptyDisc(128), 0.1, 3)) == doctest::Approx(1.0).epsilon(0.02));
}

TEST_CASE("corrections at the hits alone inflate the light, more with each iteration") {
  // A share 0.1 of the hits' excess is added each time: + 65 % after one iteration, where the kernel holds many hits.
  const HitMap flat = poissonHits(emptySky(128, 128), 0.1, 4);
  double last = gain(marvastiWith({9.0, 0, 1.0}), flat);
  for (const int iterations : {1, 3, 10}) {
    const double next = gain(marvastiWith({9.0, iterations, 1.0}), flat);
    CAPTURE(next);
    CHECK(next > 1.2 * last);
    last = next;
  }
  CHECK(last > 2.5);
}

TEST_CASE("a relaxation above two over the density makes Marvasti's iteration diverge, which is stopped and said") {
  const HitMap dense = poissonHits(emptySky(96, 96), 5.0, 8);
  // Errors of smooth parts are multiplied by 1 - relaxation: by more than a tenth they stop at once, otherwise after
  // two.
  for (const auto& [relaxation, late] : {std::pair{2.5, 1}, {2.04, 2}}) {
    const Reconstruction stopped = reconstructHits(dense, MarvastiSettings{8.0, 200, relaxation}, {});
    REQUIRE(stopped.remarks.size() == 2);
    CAPTURE(stopped.remarks[1]);
    int last = 0, best = 0;
    double from = 0.0, to = 0.0;
    REQUIRE(std::sscanf(stopped.remarks[1].c_str(), "iteration %d: the residual grew from %lf to %lf; stopped at %d",
                        &last, &from, &to, &best) == 4);
    CHECK(last == best + late);
    CHECK(to > from);
    CHECK(allFinite(stopped.lights[0]));
    // What is kept is the picture that as many iterations as that make.
    CHECK(stopped.lights[0].at(40, 40) ==
          reconstructHits(dense, MarvastiSettings{8.0, best, relaxation}, {}).lights[0].at(40, 40));
  }
  CHECK(reconstructHits(dense, MarvastiSettings{8.0, 20, 1.0}, {}).remarks.size() == 1);
}

TEST_CASE("an iteration that is asked to stop does so") {
  const HitMap map = poissonHits(emptySky(32, 32), 1.0, 9);
  const std::atomic<bool> stop{true};
  CHECK_THROWS_AS(reconstructHits(map, MarvastiSettings{4.0, 5, 1.0}, {{}, &stop}), ReconStopped);
}

}  // namespace parhelion
