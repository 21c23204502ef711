// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include <glm/geometric.hpp>

#include "picture/colour_space.h"
#include "picture/exr.h"
#include "picture/temporary_directory.h"
#include "render/measured_tally.h"
#include "render/measurements.h"
#include "render/scene_attributes.h"
#include "render/scenes.h"
#include "render/sky_files.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

bool sameLight(const SkyTally& skyA, const SkyTally& skyB) {
  const Tally &a = skyA.parts().front().tally, &b = skyB.parts().front().tally;
  for (int pixel = 0; pixel < a.pixels(); ++pixel)
    for (int slot = 0; slot < a.slots(); ++slot)
      if (a.raw(pixel, slot) != b.raw(pixel, slot)) return false;
  return a.info.intercepted == b.info.intercepted && a.info.undeviated == b.info.undeviated;
}

TraceControl threads(int count) {
  TraceControl control;
  control.threads = count;
  return control;
}

}  // namespace

TEST_CASE("an exposure has the same bits with one thread and with three, and its tally knows what it is of") {
  const LoadedScene loaded = smallScene();
  const Cloud cloud = cloudOf(loaded.scene);
  const TracedSky one = traceSky(loaded, cloud, threads(1)), three = traceSky(loaded, cloud, threads(3));
  CHECK(one.tally == three.tally);
  CHECK(one.tally.info().rays == std::vector<RayRange>{{0, 20'000}});
  CHECK(one.tally.info().scene == loaded.text);
  CHECK(one.tally.info().version == PARHELION_VERSION);
  CHECK(one.tally.info().camera == loaded.scene.camera);
  CHECK(one.tally.info().interceptedLight() > 20'000 * 0.9);
  CHECK(std::abs(one.report.energy.imbalance()) < 1e-9);
}

TEST_CASE("a run says which engine and symmetry were chosen for it") {
  const auto chosen = [](const LoadedScene& loaded) {
    return chosenSettings(cloudOf(loaded.scene), loaded.scene.trace);
  };
  CHECK(chosen(columnsScene()).symmetry == Symmetry::radial);
  CHECK(chosen(columnsScene()).engine == Engine::planes);
  CHECK(chosen(smallScene()).symmetry == Symmetry::automatic);  // plates mirrored, random columns in rings
  CHECK(chosen(smallScene({"population.columns.orientation='column'"})).symmetry == Symmetry::mirror);
  CHECK(chosen(smallScene({"trace.symmetry='none'"})).symmetry == Symmetry::none);
  CHECK(chosen(smallScene({"trace.engine='embree'"})).engine == Engine::embree);

  const LoadedScene loaded = smallScene();
  const TracedSky traced = traceSky(loaded, cloudOf(loaded.scene));
  CHECK(traced.settings.symmetry == Symmetry::automatic);
  CHECK(traced.tally.symmetries() == std::vector{TallySymmetry::mirror, TallySymmetry::radial});
  CHECK(traced.settings.engine == Engine::planes);
  CHECK(traced.settings.rays == 20'000);
}

TEST_CASE("maps and profiles count every ray for itself") {
  const LoadedScene loaded = columnsScene();
  const Cloud cloud = cloudOf(loaded.scene);
  const TraceSettings settings = settingsOfMeasurement(cloud, loaded.scene.trace);
  CHECK(settings.symmetry == Symmetry::none);
  TraceControl control;
  control.timeLimit = 1e-9;
  ProfileTally traced = emptyProfileTally(loaded, cloud, 90, 0.0, kPi);
  traceRays(cloud, settings, 0, traced.sums, control);
  // All that leaves the crystals is in one of the bins, and what is cut off is nothing to speak of.
  double energy = 0.0;
  for (const ScatterProfile::Bin& bin : traced.sums.bins()) energy += bin.energy;
  CHECK(std::abs(energy - 1.0) < 1e-3);
}

TEST_CASE("an exposure that is stopped holds the rays until then as if no more had been asked for") {
  std::atomic<bool> stop = false;
  TraceControl control;
  control.stop = &stop;
  control.onProgress = [&](std::uint64_t, double) { stop = true; };
  const LoadedScene loaded = smallScene({"trace.rays=30000000"});
  const TracedSky stopped = traceSky(loaded, cloudOf(loaded.scene), control);
  CHECK(stopped.report.interrupted);
  const std::uint64_t rays = stopped.tally.info().rayCount();
  CHECK(rays == stopped.report.rays);
  CHECK(rays > 0);
  CHECK(rays < 30'000'000);
  const LoadedScene shorter = smallScene({"trace.rays=" + std::to_string(rays)});
  CHECK(sameLight(stopped.tally, traceSky(shorter, cloudOf(shorter.scene)).tally));
}

TEST_CASE("a ray lived again has its faces, and its light adds up") {
  const Scene scene = smallScene().scene;
  const Cloud cloud = cloudOf(scene);
  const LightPath path = replayRay(scene, cloud, 123);
  CHECK(path.incident.index == 123);
  REQUIRE(!path.encounters.empty());
  double out = path.cutOff + path.lost;
  for (const Exit& exit : path.exits) out += exit.energy;
  CHECK(out == doctest::Approx(path.incident.weight).epsilon(1e-12));
}

TEST_CASE("a sky's file has its colours exactly or, clipped, none with a negative component and the same luminance") {
  const TemporaryDirectory folder;
  const LoadedScene loaded = smallScene({"recon.method='none'", "trace.symmetry='none'"});
  const TracedSky traced = traceSky(loaded, cloudOf(loaded.scene));
  Image exact = developSky(traced, loaded, 2).image, clipped = exact;
  writeSky(folder / "exact.exr", exact, traced.tally.info(), loaded);
  writeSky(folder / "clipped.exr", clipped, traced.tally.info(), loaded, Gamut::clip);
  const ExrFile one = readExr(folder / "exact.exr"), other = readExr(folder / "clipped.exr");
  CHECK_FALSE(one.attributes.contains(kGamutKey));
  CHECK(other.attributes.at(kGamutKey) == "clip");
  int outside = 0;
  for (std::size_t i = 0; i < one.image.pixels(); ++i) {
    Vec3 before, after;
    for (int c = 0; c < 3; ++c) {
      before[c] = (*one.image.rgb()[static_cast<std::size_t>(c)])[i];
      after[c] = (*other.image.rgb()[static_cast<std::size_t>(c)])[i];
      REQUIRE(after[c] >= 0.0);
    }
    const bool isOutside = std::min({before.x, before.y, before.z}) < 0.0;
    outside += isOutside ? 1 : 0;
    if (!isOutside) REQUIRE(after == before);
    const double luminance = std::max(0.0, glm::dot(kRec709Luminance, before));
    REQUIRE(glm::dot(kRec709Luminance, after) == doctest::Approx(luminance).epsilon(1e-5));
  }
  CHECK(outside > 0);
}

TEST_CASE("nothing is printed from a scene to its files") {
  const TemporaryDirectory folder;
  const LoadedScene loaded = smallScene({"sun.visible=true"});
  Printed printed;
  const TracedSky traced = traceSky(loaded, cloudOf(loaded.scene));
  ReconstructedSky sky = developSky(traced, loaded, 2);
  const SkyFiles files{folder / "sky.exr", folder / "sky.png", 1.5};
  const WrittenSky written = writeSkyFiles(files, sky.image, traced.tally.info(), loaded);
  const Cloud cloud = cloudByLight(loaded.scene);
  MapTally map = emptyMapTally(loaded, cloud, 18);
  traceRays(cloud, settingsOfMeasurement(cloud, loaded.scene.trace), 0, map.sums);
  writeTally(folder / "map.tally.exr", map);
  CHECK(printed.text() == "");
  CHECK(written.exposure == 1.5);
  CHECK(written.badPixels == 0);
  CHECK(folder.names().size() == 3);
  CHECK(exposureText(1.5) == "+1.50 stops");
}
