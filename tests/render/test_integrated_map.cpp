// SPDX-License-Identifier: Apache-2.0
// Light over the whole sphere without rays, or with rays for some populations alone, held against that of rays.
#include <cmath>
#include <numeric>
#include <string>

#include <doctest/doctest.h>

#include "math/rotation.h"
#include "render/measurements.h"
#include "render/mixed_sky.h"
#include "render/traced_sky.h"
#include "statistics.h"
#include "trace/sky_map.h"

using namespace parhelion;

namespace {

constexpr int kBins = 36;  // of 5 degrees, to half a turn

const std::string kGreen = "[sun]\nelevation = 22.0\nspectrum = 550.0\n";
const std::string kLines =
    "[sun]\nelevation = 22.0\nspectrum = { wavelengths = [440, 560, 640], weights = [3.0, 1.0, 1.0] }\n";
const std::string kRandom = "[[population]]\nname = \"random\"\naspect = 1.0\norientation = \"random\"\n";
const std::string kPlates = "[[population]]\nname = \"plates\"\naspect = 0.3\norientation = \"plate\"\ntilt = 3.0\n";
const std::string kParry =
    "[[population]]\nname = \"parry\"\naspect = 1.5\norientation = \"parry\"\ntilt = 1.0\nroll = 1.0\n";
const std::string kRays = "[trace]\nseed = 3\nrays = \"3M\"\n";

LoadedScene sceneOf(const std::string& text, const std::string& more = "") {
  return parseScene(text + kRays + more, "map.toml");
}

LightMap traced(const Scene& scene) {
  const Cloud cloud = cloudByLight(scene);
  SkyMap map(cloud.sun().toCentre(), kBins);
  traceRays(cloud, settingsOfMeasurement(cloud, scene.trace), 0, map);
  return map.light();
}

/// That all bins agree, and how many could be compared.
int compared(const LightMap& a, const LightMap& rays) {
  int bins = 0;
  double all = 0.0;
  for (std::size_t bin = 0; bin < rays.energy.size(); ++bin) {
    all += a.energy[bin];
    // Few hits of unequal light are not spread as sigmas say.
    if (rays.error[bin] == 0.0 || rays.error[bin] > 0.05 * rays.energy[bin]) continue;
    CAPTURE(bin);
    CHECK(std::abs(a.energy[bin] - rays.energy[bin]) < kSigmas * std::hypot(a.error[bin], rays.error[bin]));
    ++bins;
  }
  const double ofRays = std::accumulate(rays.energy.begin(), rays.energy.end(), 0.0);
  CHECK(all == doctest::Approx(ofRays).epsilon(2e-3));
  return bins;
}

int integrated(const LoadedScene& loaded, double error) {
  const MixedMap map = mixMap(loaded, kBins, error);
  CHECK(map.made.report.rays == 0);
  CHECK(map.made.sky.reached);
  return compared(map.light, traced(loaded.scene));
}

}  // namespace

TEST_CASE("rays agree with integrated maps, bin by bin") {
  CHECK(integrated(sceneOf(kGreen + kRandom), 0.01) > 1500);
  CHECK(integrated(sceneOf(kGreen + kRandom + kPlates), 0.05) > 1500);
  CHECK(integrated(sceneOf(kGreen + kRandom, "filter = \"1-2|1-3\"\n"), 0.02) > 100);
}

TEST_CASE("a map counts the energy of lines, not their colours") {
  CHECK(integrated(sceneOf(kLines + kRandom), 0.02) > 600);
}

TEST_CASE("a map takes rays for those populations alone that cannot be integrated") {
  const LoadedScene loaded = sceneOf(kGreen + kRandom + kParry);
  const MixedMap map = mixMap(loaded, kBins, 0.02);
  CHECK(map.made.integrated == std::vector<std::string>{"random"});
  CHECK(map.made.traced == std::vector<std::string>{"parry"});
  CHECK(map.made.report.rays == 3'000'000);
  CHECK(compared(map.light, traced(loaded.scene)) > 1000);
}

TEST_CASE("bins of a map lie about multiples of its step, whatever its picture's pixels") {
  const MapGrid grid(4);  // 45 degrees
  CHECK(grid.bins() == 40);
  const auto at = [&](double azimuth, double elevation) {
    return grid.binAt(skyDirection(radians(azimuth), radians(elevation)));
  };
  CHECK(at(0.0, 0.0) == grid.bin(4, 2));
  CHECK(at(22.0, -22.0) == grid.bin(4, 2));
  CHECK(at(23.0, 23.0) == grid.bin(5, 3));
  CHECK(at(179.0, 89.0) == grid.bin(0, 4));
  CHECK(at(-179.0, -68.0) == grid.bin(0, 0));
  for (const int bins : {2, 10, 36, 180, 720}) {
    CHECK(pixelsPerBin(bins) % 2 == 0);
    CHECK(pixelsPerBin(bins) * bins >= 180);
  }
}
