// SPDX-License-Identifier: Apache-2.0
// Shares of light by raypath, integrated, held against those that rays find.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "math/rotation.h"
#include "parallel/threads.h"
#include "render/integrated_paths.h"
#include "render/traced_sky.h"
#include "statistics.h"
#include "trace/trace.h"

using namespace parhelion;

namespace {

constexpr double kReference = 550.0;

const std::string kSun = "[sun]\nelevation = 22.0\n";
const std::string kRandom = "[[population]]\nname = \"random\"\naspect = 1.0\norientation = \"random\"\n";
const std::string kPlates =
    "[[population]]\nname = \"plates\"\naspect = 0.3\norientation = \"plate\"\ntilt = 1.0\nweight = 2.0\n";
const std::string kColumns =
    "[[population]]\nname = \"columns\"\naspect = { uniform = [1.0, 3.0] }\norientation = \"column\"\ntilt = 0.5\n";

const std::string kParry = "[[population]]\nname = \"parry\"\naspect = 1.5\norientation = \"parry\"\n";

LoadedScene sceneOf(const std::string& text, const std::string& trace = "", std::uint64_t seed = 3) {
  return parseScene(kSun + text + "[trace]\nrays = \"3M\"\nseed = " + std::to_string(seed) + "\n" + trace,
                    "paths.toml");
}

using Entries = std::vector<PathLedger::Entry>;

struct Shares {
  Entries entries;
  double ofIntercepted = 0.0, filtered = 0.0, cutOff = 0.0;
  bool reached = false;
};

Shares integrated(const LoadedScene& loaded, const PathLedgerScope& scope, double error) {
  const Cloud cloud = cloudByLight(loaded.scene);
  const IntegratedPaths paths = integratePaths(loaded.scene, cloud, scope, error);
  return {paths.ledger.entries(kReference), paths.ledger.shareOfIntercepted(), paths.filtered, paths.cutOff,
          paths.reached};
}

Shares traced(const LoadedScene& loaded, const PathLedgerScope& scope) {
  const Cloud cloud = cloudByLight(loaded.scene);
  PathLedger ledger(cloud, scope);
  TraceSettings settings = loaded.scene.trace;
  settings.symmetry = Symmetry::none;
  const TraceReport report = traceRays(cloud, settings, 0, ledger);
  return {ledger.entries(kReference), ledger.shareOfIntercepted(),
          report.energy.filtered.value() / report.energy.in.value()};
}

/// That the strongest paths of one are as strong in the other, and are called the same.
void checkStrongest(const Entries& all, const Entries& others, std::size_t most) {
  for (std::size_t k = 0; k < std::min(most, all.size()); ++k) {
    const PathLedger::Entry& a = all[k];
    CAPTURE(a.path);
    CAPTURE(a.population);
    const auto b = std::ranges::find_if(
        others, [&](const auto& other) { return other.path == a.path && other.population == a.population; });
    REQUIRE(b != others.end());
    CHECK(std::abs(a.share - b->share) < kSigmas * std::hypot(a.error, b->error));
    CHECK(a.name == b->name);
    CHECK(a.leastDeviation.has_value() == b->leastDeviation.has_value());
  }
}

double sumOf(const Entries& entries) {
  double sum = 0.0;
  for (const PathLedger::Entry& entry : entries) sum += entry.share;
  return sum;
}

}  // namespace

TEST_CASE("the strongest paths are as strong as rays find them") {
  for (const std::string& scene : {kRandom, kPlates + kRandom, kColumns, kParry}) {
    CAPTURE(scene);
    const LoadedScene loaded = sceneOf(scene);
    const Shares integral = integrated(loaded, {}, 1e-3), rays = traced(loaded, {});
    CHECK(integral.reached);
    checkStrongest(integral.entries, rays.entries, 30);
    CHECK(sumOf(integral.entries) == doctest::Approx(1.0).epsilon(1e-9));
    CHECK(integral.ofIntercepted == doctest::Approx(rays.ofIntercepted).epsilon(2e-3));
    CHECK(integral.filtered == 0.0);
    CHECK(integral.cutOff < 1e-5);
  }
}

TEST_CASE("shares of two seeds agree within the errors that they state") {
  const Shares one = integrated(sceneOf(kPlates + kRandom, "", 1), {}, 1e-3),
               other = integrated(sceneOf(kPlates + kRandom, "", 2), {}, 1e-3);
  checkStrongest(one.entries, other.entries, 60);
  // Errors are neither too large: of sixty differences some are as large as the errors say.
  double squares = 0.0;
  for (std::size_t k = 0; k < 60; ++k) {
    const PathLedger::Entry& a = one.entries[k];
    const auto b = std::ranges::find_if(
        other.entries, [&](const auto& e) { return e.path == a.path && e.population == a.population; });
    const double apart = (a.share - b->share) / std::hypot(a.error, b->error);
    squares += apart * apart;
  }
  CHECK(squares > 25.0);
  CHECK(squares < 120.0);
}

TEST_CASE("paths of a part of the sky, of a layer and of what is filtered are those of rays") {
  PathLedgerScope scope;
  scope.region = SkyRegion{skyDirection(radians(22.0), radians(22.0)), radians(4.0)};
  LoadedScene loaded = sceneOf(kPlates + kRandom);
  Shares integral = integrated(loaded, scope, 4e-3), rays = traced(loaded, scope);
  checkStrongest(integral.entries, rays.entries, 10);
  CHECK(integral.ofIntercepted == doctest::Approx(rays.ofIntercepted).epsilon(0.02));
  CHECK(std::acos(glm::dot(integral.entries[0].toPeak, scope.region->toCentre)) < scope.region->radius);

  scope = {};
  scope.symmetry = PathSymmetry::none;
  loaded = sceneOf(kPlates, "filter = \"3-*-5|1-3, symmetry = none\"\n");
  integral = integrated(loaded, scope, 4e-3);
  rays = traced(loaded, scope);
  checkStrongest(integral.entries, rays.entries, 10);
  CHECK(integral.filtered == doctest::Approx(rays.filtered).epsilon(0.01));

  const std::string layers =
      "[[layer]]\nname = \"wedge\"\npaths = \"3-5\"\n[[layer]]\nname = \"upright\"\ntilt = [0, 1]\n"
      "populations = [\"plates\"]\n";
  for (const int layer : {0, 1, 2}) {
    CAPTURE(layer);
    scope = {};
    scope.layer = layer;
    loaded = sceneOf(kPlates + kRandom + layers);
    integral = integrated(loaded, scope, 4e-3);
    rays = traced(loaded, scope);
    checkStrongest(integral.entries, rays.entries, 10);
    CHECK(integral.ofIntercepted == doctest::Approx(rays.ofIntercepted).epsilon(0.01));
  }
}

TEST_CASE("the bits of shares do not depend on threads, and what cannot be integrated is refused") {
  const LoadedScene loaded = sceneOf(kPlates);
  const auto of = [&](int threads) { return withThreads(threads, [&] { return integrated(loaded, {}, 1e-2); }); };
  const Shares one = of(1), two = of(2);
  REQUIRE(one.entries.size() == two.entries.size());
  for (std::size_t k = 0; k < one.entries.size(); ++k) {
    CHECK(one.entries[k].share == two.entries[k].share);
    CHECK(one.entries[k].error == two.entries[k].error);
    CHECK(one.entries[k].toPeak == two.entries[k].toPeak);
  }
  const LoadedScene lowitz = sceneOf("[[population]]\nname = \"spun\"\norientation = \"lowitz\"\n");
  CHECK(objectionToIntegratedPaths(lowitz.scene).find("spun") != std::string::npos);
  CHECK_THROWS_AS(integrated(lowitz, {}, 1e-2), std::invalid_argument);
}
