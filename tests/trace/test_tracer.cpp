// SPDX-License-Identifier: Apache-2.0
// One tracer for several ranges: what it leaves in a film does not depend on how the rays came to it.
#include <doctest/doctest.h>

#include <functional>
#include <stdexcept>
#include <vector>

#include "skies.h"
#include "trace/scatter_profile.h"
#include "trace/sky_map.h"
#include "trace/tracer.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

void traceAll(Tracer& tracer, RayRange range) {
  while (const std::uint64_t traced = tracer.traceSome(range)) range = {range.first + traced, range.count - traced};
}

/// The same rays in three ranges, the last one first, with a look at the result after each.
void traceInParts(const Cloud& cloud, Film& film, std::uint64_t rays, int threads, const std::function<void()>& look) {
  const std::uint64_t third = rays / 3 / cloud.bundleSize() * cloud.bundleSize();
  Tracer tracer(cloud, {.rays = rays}, film, threads);
  for (const RayRange& range : {RayRange{2 * third, rays - 2 * third}, RayRange{0, third}, RayRange{third, third}}) {
    traceAll(tracer, range);
    tracer.collect();
    film.finish();
    look();
    if (range.first != third) film.reopen();
  }
  CHECK(tracer.counts().rays == rays);
}

SkyTally emptyTally(const Cloud& cloud, const CameraSettings& camera, TallySymmetry symmetry) {
  TallyInfo info;
  info.camera = camera;
  info.white = cloud.spectrum().white();
  info.sunElevation = std::asin(cloud.sun().toCentre().z);
  return SkyTally(info, cloud.spectrum().colours(), {symmetry});
}

}  // namespace

TEST_CASE("a tally traced in parts and looked at between them has the bits of one traced at once") {
  constexpr std::uint64_t kRays = 30'001;  // the last bundle is cut short
  struct Way {
    Symmetry symmetry;
    CameraSettings camera;
  };
  // Even and odd widths, of which one has a middle column, and a camera that sees no mirror image of itself.
  const CameraSettings ahead = lookAt(Projection::rectilinear, 0.0, 20.0, 0.0, 70.0, 40, 30);
  CameraSettings odd = ahead;
  odd.width = 41;
  const std::vector<Way> ways{{Symmetry::none, ahead},
                              {Symmetry::mirror, ahead},
                              {Symmetry::mirror, odd},
                              {Symmetry::mirror, wholeSphere()},
                              {Symmetry::radial, wholeSphere()}};
  for (const Way& way : ways) {
    const Cloud cloud = sunlit({way.symmetry == Symmetry::radial ? prismPopulation(1.0) : plates()});
    const Tally whole = traceSky(cloud, way.camera, by(way.symmetry, kRays, 1));
    for (const int threads : {1, 2, 7}) {
      SkyTally parts = emptyTally(cloud, way.camera, symmetriesOf(cloud, way.symmetry).front());
      const Tally& tally = parts.parts().front().tally;
      const auto film = makeFilm(parts, cloud, way.symmetry);
      LightTotal::Units last = 0;
      traceInParts(cloud, *film, kRays, threads, [&] {
        CHECK(totalLuminance(tally) > 0.0);
        CHECK((tally.info.intercepted.units() > last));
        last = tally.info.intercepted.units();
      });
      parts.info().rays = {{0, kRays}};
      CHECK(tally == whole);
    }
  }
}

TEST_CASE("a film that is finished in between is complete: its tally is that of the rays until then") {
  const Cloud cloud = sunlit({plates()});
  const CameraSettings camera = lookAt(Projection::rectilinear, 0.0, 20.0, 0.0, 70.0, 41, 30);
  SkyTally tally = emptyTally(cloud, camera, TallySymmetry::mirror);
  const auto film = makeFilm(tally, cloud, Symmetry::mirror);
  Tracer tracer(cloud, {}, *film, 2);
  traceAll(tracer, {0, 10'000});
  tracer.collect();
  film->finish();
  tally.info().rays = {{0, 10'000}};
  CHECK(tally.parts().front().tally == traceSky(cloud, camera, by(Symmetry::mirror, 10'000, 1)));
}

TEST_CASE("profile and map traced in parts have the bits of those traced at once") {
  constexpr std::uint64_t kRays = 30'001;
  const Cloud cloud = sunlit({plates()});
  ScatterProfile whole(180, 0.0, kPi), parts(180, 0.0, kPi);
  SkyMap wholeMap(cloud.sun().toCentre(), 18), partsMap(cloud.sun().toCentre(), 18);
  traceRays(cloud, {.rays = kRays}, 0, whole);
  traceRays(cloud, {.rays = kRays}, 0, wholeMap);
  traceInParts(cloud, parts, kRays, 2, [] {});
  traceInParts(cloud, partsMap, kRays, 2, [] {});
  for (int bin = 0; bin < 180; ++bin) CHECK(parts.bins()[bin].energy == whole.bins()[bin].energy);
  CHECK(parts.summary().gError == whole.summary().gError);
  CHECK(parts.summary().byOrder == whole.summary().byOrder);
  for (int row = 0; row < wholeMap.rows(); ++row)
    for (int column = 0; column < wholeMap.columns(); ++column)
      CHECK(partsMap.error(column, row) == wholeMap.error(column, row));
}

TEST_CASE("a range starts with the first ray of a bundle, and an empty one is no work") {
  const Cloud cloud = sunlit({plates()});
  REQUIRE(cloud.bundleSize() > 1);
  SkyMap map(cloud.sun().toCentre(), 18);
  Tracer tracer(cloud, {}, map);
  CHECK_THROWS_AS(tracer.traceSome({1, 100}), std::invalid_argument);
  CHECK(tracer.traceSome({0, 0}) == 0);
}
