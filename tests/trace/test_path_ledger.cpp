// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <map>
#include <numeric>
#include <string>

#include <doctest/doctest.h>

#include "crystal/convex_body.h"
#include "crystal/objs.h"
#include "crystals.h"
#include "math/rotation.h"
#include "trace/path_ledger.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

constexpr double kReference = 550.0;

PathLedger ledgerOf(const Cloud& cloud, const TraceSettings& settings, const PathLedgerScope& scope = {},
                    int threads = 0) {
  PathLedger ledger(cloud, scope);
  TraceControl control;
  control.threads = threads;
  traceRays(cloud, settings, 0, ledger, control);
  return ledger;
}

PopulationSettings plates() { return prismPopulation(0.5, AxisOrientation{Normal{0.0, radians(0.2)}}); }

/// The light of each face sequence, by hand: deviated light of single rays.
std::map<std::string, double> sharesByHand(const Cloud& cloud, const TraceSettings& settings) {
  const Intersectors engines = makeIntersectors(cloud, settings.engine);
  RaySource source(cloud, settings, 100);
  LightPath path;
  path.recordEncounters = true;
  std::map<std::string, double> shares;
  double all = 0.0;
  for (std::uint64_t ray = 0; ray < settings.rays; ++ray) {
    followRay(source, engines, settings, ray, path);
    for (const Exit& exit : path.exits) {
      if (exit.undeviated) continue;
      std::string faces;
      for (int k = 0; k <= exit.order; ++k) faces += (k ? "-" : "") + std::to_string(path.encounters[k].faceNumber);
      if (exit.order < PathClasses::kLongest) shares[faces] += exit.energy;
      all += exit.energy;
    }
  }
  for (auto& [faces, share] : shares) share /= all;
  return shares;
}

const PathLedger::Entry& entryOf(const std::vector<PathLedger::Entry>& entries, const std::string& path) {
  const auto found = std::ranges::find(entries, path, &PathLedger::Entry::path);
  REQUIRE(found != entries.end());
  return *found;
}

}  // namespace

TEST_CASE("shares of paths add up to 1, and each is that of single rays with this sequence of faces") {
  const Cloud cloud = simpleCloud({plates()});
  const TraceSettings settings{.rays = 160};
  PathLedgerScope scope;
  scope.symmetry = PathSymmetry::none;
  const auto entries = ledgerOf(cloud, settings, scope).entries(kReference);
  double sum = 0.0;
  for (const auto& entry : entries) sum += entry.share;
  CHECK(sum == doctest::Approx(1.0).epsilon(1e-7));
  const auto expected = sharesByHand(cloud, settings);
  CHECK(expected.size() > 50);
  for (const auto& [faces, share] : expected) {
    CAPTURE(faces);
    CHECK(entryOf(entries, faces).share == doctest::Approx(share).epsilon(1e-5));
  }
}

TEST_CASE("a table of paths is the same for any number of threads") {
  const Cloud cloud = simpleCloud({plates(), prismPopulation(2.0)});
  const TraceSettings settings{.rays = 30'000};
  const auto one = ledgerOf(cloud, settings, {}, 1).entries(kReference);
  const auto seven = ledgerOf(cloud, settings, {}, 7).entries(kReference);
  REQUIRE(one.size() == seven.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    CHECK(one[i].path == seven[i].path);
    CHECK(one[i].share == seven[i].share);
    CHECK(one[i].error == seven[i].error);
    CHECK(one[i].toPeak == seven[i].toPeak);
  }
}

TEST_CASE("plates' paths have their names, places and least deviations") {
  const Cloud cloud = simpleCloud({plates()}, radians(20.0));
  const auto entries = ledgerOf(cloud, {.rays = 400'000}).entries(kReference);
  const auto check = [&](const std::string& path, const std::string& name, double azimuth, double elevation,
                         double within) {
    CAPTURE(path);
    const PathLedger::Entry& entry = entryOf(entries, path);
    CHECK(entry.name.find(name) != std::string::npos);
    const SkyPoint peak = skyPoint(entry.toPeak);
    CHECK(std::abs(degrees(peak.elevation) - elevation) < within);
    if (azimuth >= 0.0) CHECK(std::abs(degrees(peak.azimuth) - azimuth) < within);
  };
  check("3-5", "parhelion", 24.576, 20.0, 0.7);
  check("3-2-5", "subparhelion", 24.576, -20.0, 0.7);
  check("1-3", "circumzenithal arc", -1.0, 65.886, 0.7);
  check("1-3-4-2", "120° parhelion", 120.0, 20.0, 0.7);
  check("1", "subsun", 0.0, -20.0, 0.7);
  CHECK(degrees(*entryOf(entries, "3-5").leastDeviation) == doctest::Approx(21.839).epsilon(1e-4));
  CHECK(degrees(*entryOf(entries, "1-3").leastDeviation) == doctest::Approx(45.733).epsilon(1e-4));
  const Cloud thin = simpleCloud({prismPopulation(0.1, AxisOrientation{Normal{0.0, radians(0.2)}})});
  const auto thinEntries = ledgerOf(thin, {.rays = 100'000}).entries(kReference);
  CHECK(degrees(*entryOf(thinEntries, "3-2-1-5").leastDeviation) == doctest::Approx(21.839).epsilon(1e-4));
  CHECK_FALSE(entryOf(entries, "3-2-5").leastDeviation);
  CHECK_FALSE(entryOf(entries, "1").leastDeviation);
}

TEST_CASE("names of halos follow where faces lie and how ice bends light, not the numbers of faces") {
  const AxisOrientation flat{Normal{0.0, radians(0.2)}};
  const auto namesIn = [&](const CrystalMesh& mesh, double index) {
    PopulationSettings population;
    population.shape = meshed(mesh);
    population.orientation = flat;
    std::map<std::string, std::string> names;
    PathLedgerScope scope;
    scope.symmetry = PathSymmetry::none;
    const Cloud cloud = simpleCloud({population}, radians(20.0), index);
    for (const auto& entry : ledgerOf(cloud, {.rays = 60'000}, scope).entries(kReference))
      names[entry.path] = entry.name;
    return names;
  };
  const auto has = [](const std::string& name, const char* part) { return name.find(part) != std::string::npos; };
  // A hexagonal plate, turned by 10 degrees about c, whose upper face is 8, the lower 7 and the sides from 1 to 6.
  std::vector<FacePlane> plate{{8, Vec3(0, 0, 1), 0.3}, {7, Vec3(0, 0, -1), 0.3}}, box = plate;
  for (int k = 0; k < 6; ++k) {
    const double azimuth = radians(10.0 + 60.0 * k);
    plate.push_back({k + 1, Vec3(std::cos(azimuth), std::sin(azimuth), 0.0), 0.8});
  }
  for (int k = 0; k < 4; ++k) box.push_back({k + 3, Vec3(std::cos(0.5 * kPi * k), std::sin(0.5 * kPi * k), 0.0), 0.8});
  auto hexagon = namesIn(convexBody(plate), 1.31);
  CHECK(has(hexagon["1-3"], "parhelion"));
  CHECK(has(hexagon["8"], "subsun"));
  CHECK(has(hexagon["8-1"], "circumzenithal arc"));
  CHECK_FALSE(has(hexagon["1-4"], "parhelion"));
  // Square plates have no wedge of 60 degrees, and all of their sides make the circumzenithal arc.
  auto square = namesIn(convexBody(box), 1.31);
  for (const auto& [path, name] : square) CHECK_MESSAGE(!has(name, "parhelion"), path);
  CHECK(has(square["8-3"], "circumzenithal arc"));
  CHECK(has(square["8-4"], "circumzenithal arc"));
  CHECK(has(square["8"], "subsun"));
  // What no wedge bends is where it is in ice.
  auto salt = namesIn(convexBody(plate), 1.4);
  CHECK(salt["1-3"].empty());
  CHECK(has(salt["8"], "subsun"));
  CHECK(has(salt["8-1-2-7"], "120° parhelion"));
}

TEST_CASE("a region of the sky has its own shares, and the brightest of its rays lights it") {
  const Cloud cloud = simpleCloud({plates(), prismPopulation(1.0)}, radians(20.0));
  const TraceSettings settings{.rays = 200'000};
  PathLedgerScope scope;
  scope.region = SkyRegion{skyDirection(radians(24.6), radians(20.0)), radians(1.0)};
  const PathLedger ledger = ledgerOf(cloud, settings, scope);
  const auto entries = ledger.entries(kReference);
  CHECK(entries.front().path == "3-5");
  CHECK(entries.front().population == 0);
  CHECK(entries.front().share > 0.5);
  REQUIRE(ledger.brightestRay());
  RaySource source(cloud, settings, 1);
  LightPath path;
  followRay(source, makeIntersectors(cloud, settings.engine), settings, *ledger.brightestRay(), path);
  double nearest = kPi;
  for (const Exit& exit : path.exits)
    nearest = std::min(nearest, angleBetween(-exit.lightDirWorld, scope.region->toCentre));
  CHECK(nearest < scope.region->radius);
}

TEST_CASE("errors of shares are those of many runs, within the scatter of such") {
  const Cloud cloud = simpleCloud({plates(), prismPopulation(1.0)}, radians(20.0));
  constexpr int kRuns = 200;
  std::vector<double> shares;
  double stated = 0.0;
  for (int seed = 1; seed <= kRuns; ++seed) {
    const auto entries = ledgerOf(cloud, {.rays = 2'000, .seed = static_cast<std::uint64_t>(seed)}).entries(kReference);
    const PathLedger::Entry& entry = entryOf(entries, "3-2-5");
    shares.push_back(entry.share);
    stated += entry.error * entry.error / kRuns;
  }
  const double mean = std::accumulate(shares.begin(), shares.end(), 0.0) / kRuns;
  double variance = 0.0;
  for (const double share : shares) variance += (share - mean) * (share - mean) / (kRuns - 1);
  // The variance of 200 runs is known to sqrt(2 / 199) = 10 %; four of that.
  CHECK(std::abs(variance / stated - 1.0) < 0.4);
}
