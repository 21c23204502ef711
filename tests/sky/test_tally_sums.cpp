// SPDX-License-Identifier: Apache-2.0
// Tallies of more rays than anybody traces in a test, by adding.
#include <doctest/doctest.h>

#include <stdexcept>

#include "picture/temporary_directory.h"
#include "sky/tally_exr.h"

using namespace parhelion;

namespace {

constexpr std::uint64_t kFew = 9'765'625;  // 1e10 / 2^10

/// A tally whose rays all bring their light to one pixel.
Tally raysInOnePixel() {
  TallyInfo info;
  info.camera.width = info.camera.height = 2;
  info.white = {0.97, 1.0, 1.05};
  info.rays = {{0, kFew}};
  info.intercepted = LightTotal(LightTotal::Units{kFew} << 28);
  info.interceptedXyz.fill(info.intercepted);
  Tally tally(info);
  for (std::uint64_t i = 0; i < kFew; ++i) tally.addExclusively(3, info.white, i % 2 == 0);
  return tally;
}

/// The same light as by as many other rays.
Tally byOtherRays(const Tally& tally) {
  Tally other = tally;
  const RayRange range = tally.info.rays.back();
  other.info.rays = {{range.end(), range.count}};
  return other;
}

}  // namespace

TEST_CASE("1e10 rays in one pixel are exact, also through files, and what is too much is refused unchanged") {
  const TemporaryDirectory directory;
  Tally tally = raysInOnePixel();
  for (int doubling = 0; doubling < 10; ++doubling) {
    writeTallyExr(directory / "other.exr", byOtherRays(tally));
    tally.merge(readTallyExr(directory / "other.exr"));
  }
  CHECK(tally.info.rays == std::vector<RayRange>{{0, 10'000'000'000}});
  CHECK(tally.luminance(3) == 1e10);
  CHECK(tally.raw(3, Tally::kY) == std::int64_t{10'000'000'000} << 28);
  CHECK(tally.raw(3, Tally::kFirstHalf) == (std::int64_t{5'000'000'000} << 28) + (std::int64_t{512} << 28));
  CHECK(tally.squares(3) == 1e10);
  CHECK(tally.hits(3) == 10'000'000'000);
  CHECK(tally.info.interceptedLight() == 1e10);
  writeTallyExr(directory / "all.exr", tally);
  CHECK(readTallyExr(directory / "all.exr") == tally);

  tally.merge(byOtherRays(tally));  // 2e10 still fit, 4e10 do not
  const Tally before = tally;
  CHECK_THROWS_AS(tally.merge(byOtherRays(tally)), std::overflow_error);
  CHECK(tally == before);
}

TEST_CASE("rings whose light does not fit into pixels any more are not added, and nothing changes") {
  TallyInfo info;
  info.symmetry = TallySymmetry::radial;
  info.rays = {{0, 1}};
  info.camera.width = info.camera.height = 2;
  Tally tally(info, 1);
  RadialSky& rings = tally.makeRings(info.toSun());
  for (int bin = 0; bin < rings.bins(); ++bin) {
    rings.setRaw(bin, TallySlots::kY, std::int64_t{1} << 51);
    rings.setRaw(bin, TallySlots::kHits, 1);
  }
  Tally other = tally;
  for (int times = 0;; ++times) {
    REQUIRE(times < 20);
    other = byOtherRays(tally);
    const Tally before = tally;
    try {
      tally.merge(other);
    } catch (const std::overflow_error&) {
      CHECK(tally == before);
      break;
    }
  }
}
