// SPDX-License-Identifier: Apache-2.0
// However the rays of a run are divided, what their tallies hold together is the same to the bit.
#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <stdexcept>
#include <vector>

#include "damage.h"
#include "picture/temporary_directory.h"
#include "render/measured_tally.h"
#include "render/scenes.h"
#include "sky/tally_exr.h"
#include "trace/expose.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

constexpr std::uint64_t kRays = 12'001;  // the last bundle is cut short

/// Rays 0 ... kRays - 1 in about equal ranges that start with bundles.
std::vector<RayRange> slices(std::uint64_t count, std::uint64_t bundleSize) {
  std::vector<RayRange> all;
  for (std::uint64_t i = 0; i < count; ++i) {
    const auto border = [&](std::uint64_t k) { return kRays * k / count / bundleSize * bundleSize; };
    all.push_back({border(i), (i + 1 == count ? kRays : border(i + 1)) - border(i)});
  }
  return all;
}

TraceSettings until(const Scene& scene, const Cloud& cloud, const RayRange& range) {
  TraceSettings settings = chosenSettings(cloud, scene.trace);
  settings.rays = range.end();
  return settings;
}

SkyTally traced(const LoadedScene& loaded, const Cloud& cloud, const RayRange& range) {
  SkyTally tally = emptyTally(loaded, cloud);
  traceTally(tally, cloud, until(loaded.scene, cloud, range), range.first);
  return tally;
}

MapTally tracedMap(const LoadedScene& loaded, const Cloud& cloud, const RayRange& range) {
  MapTally tally = emptyMapTally(loaded, cloud, 36);
  traceRays(cloud, until(loaded.scene, cloud, range), range.first, tally.sums);
  tally.origin.rays = {range};
  return tally;
}

ProfileTally tracedProfile(const LoadedScene& loaded, const Cloud& cloud, const RayRange& range) {
  ProfileTally tally = emptyProfileTally(loaded, cloud, 77, radians(5.0), radians(77.7));
  traceRays(cloud, until(loaded.scene, cloud, range), range.first, tally.sums);
  tally.origin.rays = {range};
  return tally;
}

bool same(const SkyTally& a, const SkyTally& b) { return a == b; }

template <class Measured>
bool same(const Measured& a, const Measured& b) {
  bool alike = a.origin == b.origin && a.sums.totals() == b.sums.totals();
  for (int bin = 0; bin < a.sums.sums().size(); ++bin)
    alike = alike && a.sums.sums().sum(bin) == b.sums.sums().sum(bin) &&
            a.sums.sums().squares(bin) == b.sums.sums().squares(bin);
  return alike;
}

void add(SkyTally& sum, const SkyTally& other) { sum.merge(other); }
void takeOut(SkyTally& sum, const SkyTally& other) { sum.subtract(other); }
template <class Measured>
void add(Measured& sum, const Measured& other) {
  mergeTally(sum, other);
}
template <class Measured>
void takeOut(Measured& sum, const Measured& other) {
  subtractTally(sum, other);
}

/// Traces in 1, 3 and 64 slices, adds them in any order and takes one out again.
template <class Trace>
void checkPartitions(const LoadedScene& loaded, const Trace& trace) {
  const Cloud cloud = cloudOf(loaded.scene);
  const auto whole = trace(loaded, cloud, {0, kRays});
  std::mt19937 random(1);
  for (const std::uint64_t count : {1, 3, 64}) {
    CAPTURE(count);
    auto ranges = slices(count, static_cast<std::uint64_t>(cloud.bundleSize()));
    auto last = trace(loaded, cloud, ranges.back());
    const auto lastAlone = last;
    for (int order = 0; order < (count == 3 ? 6 : 1); ++order) {
      count == 3 ? static_cast<void>(std::next_permutation(ranges.begin(), ranges.end(),
                                                           [](auto& a, auto& b) { return a.first < b.first; }))
                 : std::shuffle(ranges.begin(), ranges.end(), random);
      auto sum = trace(loaded, cloud, ranges[0]);
      for (std::size_t i = 1; i < ranges.size(); ++i) add(sum, trace(loaded, cloud, ranges[i]));
      CHECK(same(sum, whole));
      if (count == 1) continue;
      auto without = sum;
      takeOut(without, lastAlone);
      CHECK_FALSE(same(without, whole));
      CHECK_THROWS_AS(takeOut(without, lastAlone), std::invalid_argument);
      add(without, lastAlone);
      CHECK(same(without, whole));
      CHECK_THROWS_AS(add(sum, lastAlone), std::invalid_argument);
      CHECK(same(sum, whole));
    }
  }
}

const std::vector<std::vector<std::string>>& waysToCount() {
  static const std::vector<std::vector<std::string>> ways{
      {"trace.symmetry=none"},
      {},                              // mirrored, through a camera that is its own mirror image
      {"camera.resolution=[47, 31]"},  // with a middle column
      {"camera.azimuth=20"},           // mirrored without folding
      {"sun.spectrum=[450, 550, 650]", "trace.sampler=sobol"},
      {"sun.spectrum=550"},
  };
  return ways;
}

}  // namespace

TEST_CASE("plain and mirrored tallies of 1, 3 and 64 slices are those of one run, in any order") {
  for (const auto& overrides : waysToCount()) {
    CAPTURE(overrides.size());
    checkPartitions(smallScene(overrides), traced);
  }
}

TEST_CASE("tallies with layers of 1, 3 and 64 slices are those of one run, in any order") {
  checkPartitions(parseScene(smallScene().text + "[[layer]]\nname = 'wedge'\npaths = '3-5'\n[[layer]]\nname = 'ends'\n"
                                                 "paths = '*-basal-*'\n",
                             "layered.toml"),
                  traced);
}

TEST_CASE("radial tallies of 1, 3 and 64 slices are those of one run, in any order") {
  const LoadedScene loaded = columnsScene();
  REQUIRE(emptyTally(loaded, cloudOf(loaded.scene)).parts().front().tally.rings() != nullptr);
  checkPartitions(loaded, traced);
}

TEST_CASE("maps and profiles of 1, 3 and 64 slices are those of one run, in any order") {
  checkPartitions(smallScene(), tracedMap);
  checkPartitions(smallScene(), tracedProfile);
  checkPartitions(columnsScene(), tracedMap);
  checkPartitions(columnsScene(), tracedProfile);
}

TEST_CASE("tallies of skies, maps and profiles come back from their files to the bit") {
  const TemporaryDirectory directory;
  const auto path = directory / "a.tally.exr";
  for (const LoadedScene& loaded : {smallScene(), columnsScene(), smallScene({"sun.spectrum=550"})}) {
    const Cloud cloud = cloudOf(loaded.scene);
    for (const RayRange& range : {RayRange{0, 2}, RayRange{4, 6001}}) {
      const SkyTally tally = traced(loaded, cloud, range);
      writeSkyTallyExr(path, tally);
      CHECK(readSkyTallyExr(path) == tally);
      CHECK(readTallyInfo(path) == tally.info());
      const MapTally map = tracedMap(loaded, cloud, range);
      writeTally(path, map);
      CHECK(same(readMapTally(path), map));
      CHECK(readTallyOrigin(path) == map.origin);
      CHECK_THROWS_AS(readTallyExr(path), std::runtime_error);
      CHECK_THROWS_AS(readProfileTally(path), std::runtime_error);
      const ProfileTally profile = tracedProfile(loaded, cloud, range);
      writeTally(path, profile);
      CHECK(same(readProfileTally(path), profile));
      CHECK_THROWS_AS(readMapTally(path), std::runtime_error);
    }
  }
}

TEST_CASE("a flipped bit or a cut in the tally of a map or a profile is refused, or changes nothing that is read") {
  const TemporaryDirectory directory;
  const auto path = directory / "t.exr";
  const LoadedScene loaded = smallScene();
  const Cloud cloud = cloudOf(loaded.scene);
  const auto check = [&](const auto& tally, const auto& read) {
    writeTally(path, tally);
    const Survived survived = damaged(path, [&] {
      auto found = read();
      found.origin.version = tally.origin.version;
      return same(found, tally);
    });
    CHECK(survived.readWrong == 0);
    CHECK(survived.refused > 100);
  };
  MapTally map = emptyMapTally(loaded, cloud, 6);
  traceRays(cloud, until(loaded.scene, cloud, {0, 300}), 0, map.sums);
  map.origin.rays = {{0, 300}};
  check(map, [&] { return readMapTally(path); });
  check(tracedProfile(loaded, cloud, {0, 300}), [&] { return readProfileTally(path); });
}

TEST_CASE("maps and profiles of other bins or scenes do not add up") {
  const LoadedScene loaded = smallScene(), other = smallScene({"population.plates.tilt=3"});
  const Cloud cloud = cloudOf(loaded.scene);
  MapTally map = tracedMap(loaded, cloud, {0, 100});
  const MapTally before = map;
  CHECK_THROWS_AS(mergeTally(map, emptyMapTally(loaded, cloud, 18)), std::invalid_argument);
  CHECK_THROWS_AS(mergeTally(map, tracedMap(other, cloud, {100, 100})), std::invalid_argument);
  CHECK_THROWS_AS(mergeTally(map, tracedMap(loaded, cloud, {98, 100})), std::invalid_argument);
  CHECK(same(map, before));
  ProfileTally profile = tracedProfile(loaded, cloud, {0, 100});
  CHECK_THROWS_AS(mergeTally(profile, emptyProfileTally(loaded, cloud, 77, 0.0, radians(77.7))), std::invalid_argument);
}
