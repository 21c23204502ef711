// SPDX-License-Identifier: Apache-2.0
#include "render/engine_choice.h"

#include <doctest/doctest.h>

#include "render/integrated_sky.h"
#include "render/mixed_sky.h"
#include "scenes.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

const std::string kSun = "[sun]\nelevation = 20.0\nspectrum = 550.0\nvisible = false\n";
const std::string kParry = "[[population]]\naspect = 1.5\norientation = \"parry\"\ntilt = 1.0\nroll = 1.0\n";
const std::string kPlates = "[[population]]\naspect = 0.3\norientation = \"plate\"\ntilt = 2.0\n";
const std::string kCamera = "[camera]\nprojection = \"fisheye-equal-area\"\nresolution = [64, 64]\n";

LoadedScene sceneOf(const std::string& populations) {
  return parseScene(kSun + populations + kCamera + "[trace]\nseed = 3\nrays = \"2G\"\n", "choice.toml");
}

}  // namespace

TEST_CASE("rays are forecast to within a factor of three") {
  const LoadedScene loaded = sceneOf(kParry);
  constexpr double kGoal = 0.1;
  const auto forecast = forecastRays(loaded, kGoal, {});
  REQUIRE(forecast);
  const MixedSky traced = mixSky(loaded, {kGoal, true, {}});
  REQUIRE(traced.sky.reached);
  const auto rays = static_cast<double>(traced.sky.info.rayCount());
  CHECK(rays > 600'000.0);  // well beyond what the forecast looks at
  CHECK(forecast->rays > rays / 3.0);
  CHECK(forecast->rays < rays * 3.0);
}

TEST_CASE("half the error takes more rays, and more than the scene has are dearer") {
  LoadedScene loaded = sceneOf(kPlates);
  const auto some = forecastRays(loaded, 0.1, {}), more = forecastRays(loaded, 0.05, {});
  REQUIRE((some && more));
  CHECK(more->rays > 4.0 * some->rays);
  CHECK(more->seconds > some->seconds);
  loaded.scene.trace.rays = 500'000;
  const auto few = forecastRays(loaded, 0.05, {});
  REQUIRE(few);
  CHECK(few->rays == more->rays);
  CHECK(few->seconds > more->seconds);
}

TEST_CASE("a forecast that is far above or far below what it is asked for has looked at less rays") {
  const LoadedScene loaded = sceneOf(kPlates);
  const auto whole = forecastRays(loaded, 0.03, {});
  REQUIRE(whole);
  const auto above = forecastRays(loaded, 0.03, {}, 1e-3), below = forecastRays(loaded, 0.03, {}, 1e9),
             near = forecastRays(loaded, 0.03, {}, whole->seconds);
  REQUIRE((above && below && near));
  CHECK(near->rays == whole->rays);
  CHECK(above->rays != whole->rays);
  CHECK(above->seconds > 1e-3);
  CHECK(below->rays == above->rays);
  CHECK(below->seconds < 1e9);
}

TEST_CASE("rays are looked at where the integral takes longer than two looks, and taken where they are quicker") {
  const LoadedScene loaded = sceneOf(kPlates);
  const TraceControl control;
  EngineChoice choice(loaded, 0.1, control);
  CHECK(choice.goOn(1e-3));
  CHECK_FALSE(choice.rays());
  CHECK_FALSE(choice.goOn(1e6));
  REQUIRE(choice.rays());
  CHECK(*choice.rays() < 1e3);
  CHECK(choice.integral() == 1e6 + 1e-3);
}

TEST_CASE("an integral that is not to go on is refused, before it has made anything") {
  const LoadedScene loaded = sceneOf(kPlates);
  int asked = 0;
  double work = 0.0, finer = 0.0;
  const auto refuse = [&](double left) {
    ++asked;
    work = left;
    return false;
  };
  const IntegratedSky sky = integrateSky(loaded, 0.1, nullptr, Counted::colour, refuse);
  CHECK(sky.refused);
  CHECK(sky.directions == 0);
  CHECK(asked == 1);
  CHECK(work > 0.0);
  integrateSky(loaded, 0.01, nullptr, Counted::colour, [&](double left) {
    finer = left;
    return false;
  });
  CHECK(finer > 2.0 * work);
}
