// SPDX-License-Identifier: Apache-2.0
// Clouds of several layers.
#include "render/layered_light.h"

#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "math/rotation.h"
#include "recon/reconstruct.h"
#include "render/more_orders.h"
#include "render/slab_light.h"
#include "render/traced_sky.h"
#include "sky/radiance.h"
#include "trace/sky_film.h"

using namespace parhelion;

namespace {

const std::string kPlates =
    "[[population]]\nname = \"plates\"\naspect = 0.2\norientation = \"plate\"\ntilt = 3.0\nweight = 0.5\n";
const std::string kColumns = "[[population]]\nname = \"columns\"\naspect = 1.0\n";
const std::string kHaze = "[[population]]\nname = \"haze\"\nshape = \"haze\"\ng = 0.6\nweight = 0.7\n";

std::string layerOf(const std::string& names, double depth) {
  return "[[cloud.layer]]\npopulations = [" + names + "]\noptical_depth = " + std::to_string(depth) + "\n";
}

LoadedScene sceneOf(double sun, const std::string& populations, const std::string& cloud) {
  return parseScene("[sun]\nelevation = " + std::to_string(sun) +
                        "\nspectrum = 550.0\ndiameter = 0\n[ice]\nindex = 1.31\n" + populations + cloud +
                        "[camera]\nprojection = \"equirectangular\"\nresolution = [180, 90]\n[trace]\nrays = "
                        "\"600k\"\n[recon]\nmethod = \"none\"\n",
                    "layered.toml");
}

/// Light of first order in cd/m^2.
struct FirstOrder {
  Image image;
  Camera camera;

  explicit FirstOrder(const LoadedScene& loaded) : camera(loaded.scene.camera) {
    const TracedSky traced = traceSky(loaded, cloudOf(loaded.scene));
    image = reconstruct(traced.tally, loaded.scene.recon).image;
    const Extinction::Crystals met =
        SlabLight(loaded.scene, 0.0).stack().layers().front().extinction.at(Sun(loaded.scene.sun).toCentre());
    const SlabLight slab(loaded.scene, met.undeviated / (1.0 - met.ofHaze));
    addHaze(image, camera, loaded.scene, slab.ofHaze());
    slab.apply(image, camera);
  }

  double mean(const std::string& channel) const {
    double sum = 0.0;
    for (const float sample : *image.find(channel)) sum += static_cast<double>(sample);
    return sum / static_cast<double>(image.pixels());
  }
  const std::vector<float>& light() const { return *image.find("G"); }
};

}  // namespace

TEST_CASE("two layers of the same crystals and haze have the light of first order of one of the summed depth") {
  const std::string all = kPlates + kColumns + kHaze, names = "\"plates\", \"columns\", \"haze\"";
  const FirstOrder one(sceneOf(20.0, all, "[cloud]\noptical_depth = 1.0\n"));
  const FirstOrder two(sceneOf(20.0, all, "[cloud]\n" + layerOf(names, 0.3) + layerOf(names, 0.7)));
  REQUIRE(one.light().size() == two.light().size());
  for (std::size_t i = 0; i < one.light().size(); ++i)
    CHECK(two.light()[i] == doctest::Approx(one.light()[i]).epsilon(2e-3));
}

TEST_CASE("first order of layers by walks is the closed form, in every block within 4 sigma") {
  const LoadedScene loaded = sceneOf(25.0, kPlates + kColumns + kHaze,
                                     "[cloud]\n" + layerOf("\"columns\"", 0.2) + layerOf("\"haze\", \"plates\"", 0.5) +
                                         layerOf("\"plates\"", 0.3) + layerOf("\"columns\", \"haze\"", 0.4));
  const FirstOrder closed(loaded);
  const Scene& scene = loaded.scene;
  const SlabLight slab(scene, 0.0);
  const ManyOrders orders({scene.sun, scene.ice, scene.populations, scene.hazes}, 1, slab.stack(), Engine::automatic);
  TallyInfo info;
  info.camera = scene.camera;
  Tally tally(info, 1);
  SkyFilm film({&tally}, nullptr);
  OrderDeposits deposits;
  deposits.first = 1;
  deposits.scale = 1.0 / orders.scattered();
  constexpr std::uint64_t kWalks = 150'000;
  traceOrders(orders, kWalks, scene.trace, deposits, film).light.addTo(tally.info);
  tally.info.rays = {{0, kWalks}};
  const Image walked = plainRadiance(tally);
  const double unit = slab.illuminance() * std::sin(scene.sun.elevation) / deposits.scale;
  constexpr int kSide = 15;
  for (int y = 0; y < 90; y += kSide)
    for (int x = 0; x < 180; x += kSide) {
      CAPTURE(x);
      CAPTURE(y);
      double difference = 0.0, squares = 0.0, all = 0.0;
      for (int j = y; j < y + kSide; ++j)
        for (int i = x; i < x + kSide; ++i) {
          const auto at = static_cast<std::size_t>(j * 180 + i);
          const double own = closed.camera.solidAngle(i, j);
          const double light = own * static_cast<double>(closed.light()[at]);
          difference += light - own * unit * static_cast<double>((*walked.find("G"))[at]);
          squares += own * own *
                     (unit * unit * static_cast<double>((*walked.find(kVarianceChannel))[at]) +
                      static_cast<double>((*closed.image.find(kVarianceChannel))[at]));
          all += light;
        }
      // Undeviated shares are known to half a hundredth of all light, and shadows to a thousandth.
      CHECK(std::abs(difference) < 4.0 * std::sqrt(squares) + 0.005 * all);
    }
}

TEST_CASE("haze over plates dims them seen from above, both ways, and haze under them does not") {
  constexpr double kSun = 30.0, kHazeDepth = 0.8;
  const std::string plates = layerOf("\"plates\"", 1e-4), haze = layerOf("\"haze\"", kHazeDepth);
  const FirstOrder bare(sceneOf(kSun, kPlates, "[cloud]\n" + plates)),
      over(sceneOf(kSun, kPlates + kHaze, "[cloud]\n" + haze + plates)),
      under(sceneOf(kSun, kPlates + kHaze, "[cloud]\n" + plates + haze));
  const std::vector<float>&alone = *bare.image.find("plates.G"), &hidden = *over.image.find("plates.G"),
        &shown = *under.image.find("plates.G");
  int seen = 0;
  for (int y = 0; y < 90; ++y) {
    const double elevation = radians(90.0 - 2.0 * (y + 0.5)), rise = std::abs(std::sin(elevation));
    if (rise < 0.1) continue;
    for (int x = 0; x < 180; ++x) {
      const auto i = static_cast<std::size_t>(y * 180 + x);
      if (!(alone[i] > 0.0F)) continue;
      ++seen;
      const double toHaze = std::exp(-kHazeDepth / std::sin(radians(kSun))), fromHaze = std::exp(-kHazeDepth / rise);
      const double above = elevation > 0.0 ? toHaze : toHaze * fromHaze, below = elevation > 0.0 ? fromHaze : 1.0;
      CHECK(hidden[i] / alone[i] == doctest::Approx(above).epsilon(2e-3));
      CHECK(shown[i] / alone[i] == doctest::Approx(below).epsilon(2e-3));
    }
  }
  CHECK(seen > 1000);
}

TEST_CASE("a layer's haze is added to the picture and to its layer for the rest") {
  const FirstOrder sky(
      sceneOf(30.0, kColumns + kHaze, "[cloud]\n" + layerOf("\"columns\"", 0.1) + layerOf("\"haze\"", 0.2)));
  CHECK(sky.mean("G") > 1.5 * sky.mean("columns.G"));
  CHECK(sky.image.find("haze.G") == nullptr);
}
