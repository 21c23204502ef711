// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "picture/temporary_directory.h"
#include "recon/reconstruct.h"
#include "render/needs.h"
#include "render/scenes.h"
#include "render/traced_sky.h"
#include "sky/tally_exr.h"
#include "trace/expose.h"
#include "trace/lane_steps.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

const std::string kLayers = R"(
[[layer]]
name = "wedge"
paths = "3-5"
[[layer]]
name = "basal"
paths = "*-basal-*, hits = 2..6"
[[layer]]
name = "upright"
tilt = [0, 2]
)";

LoadedScene withLayers(const LoadedScene& plain) { return parseScene(plain.text + kLayers, "layers.toml"); }

SkyTally tallyOf(const LoadedScene& loaded, int threads = 2, Simd simd = Simd::automatic) {
  TraceControl control;
  control.threads = threads;
  control.simd = simd;
  return traceSky(loaded, cloudOf(loaded.scene), control).tally;
}

/// The sums alone: scenes with and without layers have different names.
bool sameSums(const Tally& a, const Tally& b) {
  for (int pixel = 0; pixel < a.pixels(); ++pixel)
    for (int slot = 0; slot < a.slots(); ++slot)
      if (a.raw(pixel, slot) != b.raw(pixel, slot)) return false;
  if ((a.rings() == nullptr) != (b.rings() == nullptr)) return false;
  return (!a.rings() || *a.rings() == *b.rings()) && a.info.intercepted == b.info.intercepted &&
         a.info.undeviated == b.info.undeviated && a.info.interceptedXyz == b.info.interceptedXyz;
}

void checkAddsUp(const SkyTally& layered, const SkyTally& plain) {
  REQUIRE(layered.symmetries() == plain.symmetries());
  for (std::size_t i = 0; i < plain.symmetries().size(); ++i)
    CHECK(sameSums(layered.withoutLayers(i), plain.withoutLayers(i)));
}

std::vector<LoadedScene> allScenes() {
  std::vector<LoadedScene> scenes;
  const std::vector<std::string> small{"camera.resolution=[60, 40]", "trace.rays=20000"};
  for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(PARHELION_SOURCE_DIR) / "scenes"))
    if (entry.path().extension() == ".toml") scenes.push_back(loadScene(entry.path(), small));
  return scenes;
}

}  // namespace

TEST_CASE("layers and the rest add up to the tally without layers, to the bit, in every scene") {
  const std::vector<LoadedScene> scenes = allScenes();
  CHECK(scenes.size() >= 14);
  for (const LoadedScene& plain : scenes) {
    CAPTURE(plain.text);
    checkAddsUp(tallyOf(withLayers(plain)), tallyOf(plain));
  }
}

TEST_CASE("so they do with both engines, all registers, one, two and seven threads, and every symmetry") {
  for (const char* engine : {"trace.engine='planes'", "trace.engine='embree'"})
    for (const char* symmetry : {"trace.symmetry='auto'", "trace.symmetry='mirror'", "trace.symmetry='none'"}) {
      const LoadedScene plain = smallScene({engine, symmetry});
      const SkyTally whole = tallyOf(plain), layered = tallyOf(withLayers(plain));
      checkAddsUp(layered, whole);
      for (const Simd simd : simdHere())
        for (const int threads : {1, 7}) CHECK(tallyOf(withLayers(plain), threads, simd) == layered);
    }
}

TEST_CASE("a layer that takes everything is the tally without layers") {
  const LoadedScene plain = smallScene();
  const LoadedScene all = parseScene(plain.text + "[[layer]]\nname = 'all'\n", "all.toml");
  const SkyTally whole = tallyOf(plain), layered = tallyOf(all);
  for (std::size_t i = 0; i < whole.symmetries().size(); ++i)
    CHECK(sameSums(layered.parts()[i].tally, whole.parts()[i].tally));
}

TEST_CASE("tallies with layers come back from their files to the bit, and merge as others do") {
  const TemporaryDirectory directory;
  const LoadedScene loaded = withLayers(smallScene());
  const Cloud cloud = cloudOf(loaded.scene);
  const SkyTally whole = tallyOf(loaded);
  writeSkyTallyExr(directory / "a.exr", whole);
  CHECK(readSkyTallyExr(directory / "a.exr") == whole);

  TraceSettings settings = chosenSettings(cloud, loaded.scene.trace);
  SkyTally first = emptyTally(loaded, cloud), second = emptyTally(loaded, cloud);
  traceTally(second, cloud, settings, 8'000);
  settings.rays = 8'000;
  traceTally(first, cloud, settings);
  SkyTally sum = second;
  sum.merge(first);
  CHECK(sum == whole);
  sum.subtract(second);
  CHECK(sum == first);
  CHECK_THROWS_AS(sum.merge(tallyOf(smallScene())), std::invalid_argument);
}

TEST_CASE("pictures of layers add up to the whole picture to float rounding, and gains relight it") {
  const SkyTally tally = tallyOf(withLayers(smallScene()));
  const Image image = reconstruct(tally, AdaptiveSettings{}).image;
  const Image relit = reconstruct(tally, AdaptiveSettings{}, {{"wedge", 0.5}, {"rest", 0.0}}).image;
  double worst = 0.0, apart = 0.0;
  for (const char* colour : {"R", "G", "B"})
    for (std::size_t i = 0; i < image.pixels(); ++i) {
      const auto at = [&](const Image& of, const std::string& name) {
        const auto* samples = of.find(name);
        REQUIRE(samples != nullptr);
        return static_cast<double>((*samples)[i]);
      };
      double sum = 0.0, size = 1e-30;
      for (const std::string& layer : tally.layers()) {
        sum += at(image, layer + "." + colour);
        size += std::abs(at(image, layer + "." + colour));
      }
      worst = std::max(worst, std::abs(sum - at(image, colour)) / size);
      const double expected =
          sum - 0.5 * at(image, std::string("wedge.") + colour) - at(image, std::string("rest.") + colour);
      apart = std::max(apart, std::abs(expected - at(relit, colour)) / size);
    }
  CHECK(worst < 1.2e-7);
  CHECK(apart < 4e-7);
}

TEST_CASE("the picture of a mixed cloud has no other light than that without symmetry, where errors say so") {
  for (const auto& overrides :
       std::vector<std::vector<std::string>>{{},
                                             {"sun.elevation=5"},
                                             {"population.columns.orientation='column'",
                                              "population.plates.tilt=", "population.plates.orientation='random'"}}) {
    std::vector<std::string> plain = overrides, mixed = overrides;
    for (auto* both : {&plain, &mixed}) both->push_back("trace.rays=400000");
    plain.push_back("trace.symmetry='none'");
    mixed.push_back("trace.seed=2");
    const Tally a = tallyOf(smallScene(plain)).flattened(), b = tallyOf(smallScene(mixed)).flattened();
    double apart = 0.0, squares = 0.0;
    for (int pixel = 0; pixel < a.pixels(); ++pixel) {
      const double perA = 1.0 / a.info.interceptedLight(), perB = 1.0 / b.info.interceptedLight();
      apart += perA * a.luminance(pixel) - perB * b.luminance(pixel);
      squares += std::pow(perA * a.luminanceError(pixel), 2);
    }
    CHECK(std::abs(apart) < 4.5 * std::sqrt(squares) * 1.5);  // the other's rings scatter together
  }
}

TEST_CASE("the memory of a run counts all tallies that it has") {
  for (const LoadedScene& plain : allScenes())
    for (const LoadedScene& loaded : {plain, withLayers(plain)}) {
      const SkySize before = skySizeOf(loaded.scene), after = skySizeOf(emptyTally(loaded, cloudOf(loaded.scene)));
      CHECK(before.pixels == after.pixels);
      CHECK(before.colours == after.colours);
      // Light that a cloud scatters more than once comes to tallies of its own, one and the layers'.
      const bool hasMore = loaded.scene.cloud && loaded.scene.cloud->orders > 1;
      CHECK(before.tallies == after.tallies + (hasMore ? after.layers + 1 : 0));
      CHECK(before.layers == after.layers);
    }
}

TEST_CASE("64 layers of populations with all symmetries fit into a file") {
  const TemporaryDirectory directory;
  std::string text = smallScene().text;
  text += "[[population]]\nname = 'turned'\norientation = { zenith = 60, azimuth = 40, roll = 10 }\n";
  for (int i = 0; i < 64; ++i)
    text += "[[layer]]\nname = 'l" + std::to_string(i) + "'\npaths = 'hits = " + std::to_string(i + 1) + "'\n";
  const SkyTally tally = tallyOf(parseScene(text, "many.toml"));
  CHECK(tally.symmetries().size() == 3);
  writeSkyTallyExr(directory / "many.exr", tally);
  CHECK(readSkyTallyExr(directory / "many.exr") == tally);
}
