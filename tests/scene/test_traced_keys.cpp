// SPDX-License-Identifier: Apache-2.0
#include "scene/traced_keys.h"

#include <set>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "scene/parse_scene.h"

using namespace parhelion;

namespace {

constexpr const char* kScene = R"(
[sun]
elevation = 20
[[population]]
name = "plates"
aspect = 0.2
orientation = "plate"
tilt = 0.7
[[population]]
name = "pyramids"
shape = "pyramid"
[trace]
rays = "20k"
)";

std::uint64_t hash(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const Scene scene = parseScene(text, "scene.toml", overrides).scene;
  return hashOf(talliedKeys(scene, scene.trace));
}

}  // namespace

TEST_CASE("scenes that differ in spelling, or in what no ray knows, have one hash") {
  const std::uint64_t usual = hash(kScene);
  CHECK(hash(R"(
# The same, written by somebody else.
trace = { seed = 5, rays = 1_000_000, engine = "auto" }
recon = { method = "gaussian", sigma = 2.5 }
[[population]]
tilt = 7e-1
orientation = "plate"
name = "thin ones"
shape = "prism"
aspect = 0.20
weight = 1.0
[[population]]
shape = "pyramid"
upper = 0.5
[sun]
visible = true
elevation = 2.0e1
)") == usual);
  for (const char* override : {"trace.rays=5", "trace.seed=7", "recon.method=none", "sun.visible=true",
                               "sun.elevation=20.0", "population.plates.name=others", "camera.roll=-0.0"})
    CHECK(hash(kScene, {override}) == usual);
}

TEST_CASE("every setting that decides a tally changes the hash, each to another one") {
  const std::vector<std::string> overrides{"sun.elevation=20.000001",
                                           "sun.diameter=0",
                                           "sun.spectrum=equal",
                                           "sun.spectrum=550",
                                           "sun.spectrum=[500, 600]",
                                           "sun.spectrum={wavelengths=[500, 600], weights=[1, 2]}",
                                           "sun.spectrum={blackbody=3000}",
                                           "ice.index=1.31",
                                           "ice.index=[1.3, 1.31]",
                                           "ice.index=cubic-ice",
                                           "ice.index=salt",
                                           "ice.index={sellmeier=[[0.7, 0.01]]}",
                                           "ice.index={sellmeier=[[0.7, 0.01]], constant=1.1}",
                                           "ice.index={sellmeier=[[0.7, 0.02]]}",
                                           "ice.index={cauchy=[1.3, 0.003]}",
                                           "ice.index={cauchy=[1.3, 0.004]}",
                                           "ice.index={table=[[400, 1.32], [700, 1.31]]}",
                                           "ice.index={table=[[400, 1.32], [700, 1.3]]}",
                                           "ice.index={table=[[400, 1.32, 0], [700, 1.31, 0]]}",
                                           "population.plates.weight=2",
                                           "population.plates.aspect=0.3",
                                           "population.plates.aspect={normal=[0.2, 0.01]}",
                                           "population.plates.aspect={uniform=[0.1, 0.3]}",
                                           "population.plates.orientation=column",
                                           "population.plates.orientation=random",
                                           "population.plates.orientation=parry",
                                           "population.plates.orientation=lowitz",
                                           "population.plates.tilt=0.8",
                                           "population.plates.tilt={laplace=0.7}",
                                           "population.plates.roll=3",
                                           "population.pyramids.upper=0.6",
                                           "population.pyramids.lower=0.6",
                                           "population.pyramids.slope=30",
                                           "population.pyramids.aspect=2",
                                           "population.plates.shape=pyramid",
                                           "trace.engine=planes",
                                           "trace.engine=embree",
                                           "trace.path=chance",
                                           "trace.sampler=sobol",
                                           "trace.symmetry=none",
                                           "camera.azimuth=1",
                                           "camera.elevation=80",
                                           "camera.roll=1",
                                           "camera.fov_horizontal=170",
                                           "camera.fov_vertical=180",
                                           "camera.projection=equirectangular",
                                           "camera.resolution=[1023, 1024]",
                                           "camera.resolution=[1024, 1023]",
                                           "camera.image_circle=170",
                                           "camera.distortion=[0.1, 0, 0]",
                                           "camera.shift=[0.1, 0]",
                                           "camera.horizon=cut"};
  std::set<std::uint64_t> hashes{hash(kScene)};
  for (const std::string& override : overrides) {
    CAPTURE(override);
    std::vector<std::string> all{override};
    if (override.ends_with("orientation=random")) all = {"population.plates.tilt=", override};
    CHECK(hashes.insert(hash(kScene, all)).second);
  }
}

TEST_CASE("what is not ideal about crystals changes the hash, and their size where it matters") {
  const std::vector<std::string> sized{"population.plates.size=30", "population.pyramids.size=30",
                                       "population.plates.diffraction=false", "population.pyramids.diffraction=false"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = sized;
    all.insert(all.end(), more.begin(), more.end());
    return hash(kScene, all);
  };
  CHECK(with({}) == hash(kScene));
  CHECK(with({"ice.absorption=false"}) == hash(kScene));
  std::set<std::uint64_t> hashes{with({})};
  for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{
           {"population.plates.distortion=0.5"},
           {"population.plates.diffraction=true"},
           {"population.plates.diffraction=true", "population.plates.size=31"},
           {"population.plates.diffraction=true", "population.plates.size={uniform=[30, 31]}"},
           {"ice.absorption=true"},
           {"ice.absorption=1e-6"},
           {"ice.absorption=1e-6", "population.plates.size=31"}})
    CHECK(hashes.insert(with(more)).second);
}

TEST_CASE("maps and profiles have no camera and no symmetry in their hash") {
  const auto measured = [](const std::vector<std::string>& overrides) {
    const Scene scene = parseScene(kScene, "scene.toml", overrides).scene;
    return hashOf(tracedKeys(scene, scene.trace));
  };
  const std::uint64_t usual = measured({});
  CHECK(measured({"camera.azimuth=1", "camera.resolution=[10, 10]", "trace.symmetry=none"}) == usual);
  CHECK(measured({"sun.elevation=21"}) != usual);
  CHECK(usual != hash(kScene));
}

TEST_CASE("the hash of a scene stays what it was, so that tallies of before fit those to come") {
  CHECK(hash(kScene) == 0x8811f3d2017d5672);
}
