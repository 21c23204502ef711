// SPDX-License-Identifier: Apache-2.0
#include "render/clouded_sky.h"

#include <cmath>
#include <string>

#include <doctest/doctest.h>

#include "math/rotation.h"
#include "scene/parse_scene.h"
#include "trace/trace_orders.h"

using namespace parhelion;

namespace {

Scene sceneOf(const std::string& cloud, const std::string& ground = "0.15", const std::string& more = "") {
  return parseScene("[sun]\nelevation = 30\n[[population]]\naspect = 1.0\n[sky]\nair = true\nground = { albedo = " +
                        ground + " }\n" + cloud + more,
                    "clouded.toml")
      .scene;
}

class NoFilm : public Film {
 public:
  int add(const TracedRays&) override { return 0; }
  std::unique_ptr<Film> forThread() override { return std::make_unique<NoFilm>(); }
  void merge(Film&) override {}
};

/// A scene's sky with its cloud, and without.
struct Skies {
  Scene scene;
  AirSky clear;
  SlabLight slab;
  CloudedSky clouded;

  explicit Skies(const Scene& given)
      : scene(given),
        clear(scene.sky, scene.observer.altitude / 1000.0, scene.sun.elevation),
        slab(scene, 0.0),
        clouded(clear, slab, scene) {}
  double share(double elevation) const {
    const Vec3 to = skyDirection(1.0, radians(elevation));
    return clouded.radiance(to).y / clear.radiance(to).y;
  }
};

std::string depth(const std::string& number) { return "[cloud]\noptical_depth = " + number + "\n"; }

}  // namespace

TEST_CASE("what goes through a cloud of random columns is what walks find, within 0.12 of the light") {
  for (const double elevation : {20.0, 60.0})
    for (const double opticalDepth : {0.5, 1.0, 5.0}) {
      CAPTURE(elevation);
      CAPTURE(opticalDepth);
      Scene scene = sceneOf(depth("1"));
      scene.cloud->opticalDepth = opticalDepth;
      scene.sky.air = false;
      scene.sun.elevation = radians(elevation);
      const SlabLight slab(scene, 0.24);
      const ManyOrders orders({scene.sun, scene.ice, scene.populations, {}}, SlabSettings::kAllOrders, slab.stack(),
                              Engine::automatic);
      NoFilm none;
      const double walked = traceOrders(orders, 10'000, scene.trace, {}, none).energy.transmitted();
      const double rise = std::sin(scene.sun.elevation);
      const Vec3 toSun = skyDirection(0.0, scene.sun.elevation);
      CHECK(std::abs(cloudFlux(slab.depthToward(toSun) * rise, rise, 0.6).through - walked) < 0.12);
    }
}

TEST_CASE("a cloud gives back what it does not let through, and lets through all where it is thin") {
  for (const double g : {-0.5, 0.0, 0.7, 0.95})
    for (const double rise : {1e-6, 0.1, 0.5, 1.0})
      for (const double opticalDepth : {1e-9, 0.1, 1.0, 100.0}) {
        const CloudFlux flux = cloudFlux(opticalDepth, rise, g);
        CHECK(flux.through + flux.back == doctest::Approx(1.0));
        CHECK(flux.through > 0.0);
        CHECK(flux.through <= 1.0 + 1e-9);
      }
  CHECK(cloudFlux(1e-9, 0.5, 0.7).through == doctest::Approx(1.0));
  CHECK(cloudFlux(1000.0, 0.5, 0.7).through < 0.02);
}

TEST_CASE("behind a thin cloud the sky is clear, and under a deep one sky and ground are dim") {
  const Skies none(sceneOf("")), thin(sceneOf(depth("1e-5"))), deep(sceneOf(depth("20")));
  for (const double elevation : {10.0, 45.0, 89.0, -5.0, -60.0}) {
    CAPTURE(elevation);
    CHECK(none.share(elevation) == 1.0);
    CHECK(thin.share(elevation) == doctest::Approx(1.0).epsilon(1e-3));
  }
  CHECK(deep.share(-60.0) < 0.35);
  CHECK(deep.share(-60.0) > 0.1);
  // All sides are alike under it: the blue of the zenith has gone.
  const Vec3 up = deep.clouded.radiance(Vec3(0.0, 0.0, 1.0)), clearUp = deep.clear.radiance(Vec3(0.0, 0.0, 1.0));
  CHECK(up.z / up.y < 0.95 * clearUp.z / clearUp.y);
}

TEST_CASE("snow under a deep cloud keeps more light than dark ground, which does not send it up again") {
  const Skies snow(sceneOf(depth("5"), "0.8")), dark(sceneOf(depth("5"), "0.05"));
  CHECK(snow.share(-60.0) > 1.3 * dark.share(-60.0));
}

TEST_CASE("from the air the cloud is before the ground, from the ground it is not") {
  const std::string high = "[observer]\naltitude = 9000\n";
  const Skies flying(sceneOf(depth("20"), "0.0", high)), standing(sceneOf(depth("20"), "0.0"));
  const Vec3 down = skyDirection(1.0, radians(-60.0));
  // Ground that is black shows the sky in the cloud's upper side.
  CHECK(flying.clouded.radiance(down).y > 2.0 * standing.clouded.radiance(down).y);
}

TEST_CASE("a level cloud is seen down to the horizon of the round earth, which lies a little below it") {
  const Skies standing(sceneOf(depth("0.15")));
  const double dip = -standing.clear.horizon();
  REQUIRE(dip > 0.0);
  const auto at = [&](double elevation) { return standing.clouded.radiance(skyDirection(1.0, elevation)).y; };
  CHECK(at(-0.5 * dip) == doctest::Approx(at(1e-6)).epsilon(0.05));
  // Where a clear sky is brighter.
  CHECK(at(-0.5 * dip) < 0.8 * standing.clear.radiance(skyDirection(1.0, -0.5 * dip)).y);
}
