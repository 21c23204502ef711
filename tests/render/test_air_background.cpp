// SPDX-License-Identifier: Apache-2.0
#include "render/air_background.h"

#include <cmath>
#include <ctime>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "air/air_sky.h"
#include "optics/spectrum.h"
#include "picture/colour_space.h"
#include "picture/exr.h"
#include "picture/temporary_directory.h"
#include "render/sky_files.h"
#include "render/slab_light.h"
#include "render/traced_sky.h"
#include "scenes.h"
#include "sky/camera.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

/// A picture of a scene's camera with nothing in it, and what it was made of.
struct Dark {
  explicit Dark(const LoadedScene& loaded) : info(skyInfoOf(loaded)), camera(info.camera) {
    image = {camera.width(), camera.height(), {}};
    for (const char* name : {"R", "G", "B"}) image.add(name);
  }

  double luminance(int x, int y) const {
    const auto i = static_cast<std::size_t>(y * image.width + x);
    const auto planes = image.rgb();
    return glm::dot(kRec709Luminance, Vec3((*planes[0])[i], (*planes[1])[i], (*planes[2])[i]));
  }

  TallyInfo info;
  Camera camera;
  Image image;
};

}  // namespace

TEST_CASE("behind a halo the picture has the luminance of the sky and the ground, in cd/m^2") {
  const LoadedScene loaded = smallScene({"sky.air=true"});
  Dark dark(loaded);
  addAir(dark.image, dark.camera, dark.info, loaded.scene, 1);
  const AirSky sky(loaded.scene.sky, 0.0, loaded.scene.sun.elevation);
  for (const auto& [x, y] : {std::pair{3, 2}, {24, 10}, {40, 14}}) {
    const Vec3 toSky = *dark.camera.toSky(Vec2(x + 0.5, y + 0.5));
    CHECK(dark.luminance(x, y) == doctest::Approx(sky.radiance(toSky).y).epsilon(1e-5));
  }
}

TEST_CASE("the light of a halo is that of the cloud in the sunlight that reaches it, and as red") {
  const LoadedScene loaded = smallScene({"sky.air=true", "sun.elevation=10", "cloud.optical_depth=0.2"});
  Dark dark(loaded), lit(loaded);
  const int x = 24, y = 5;
  for (Channel& channel : lit.image.channels)
    channel.samples[static_cast<std::size_t>(y * lit.image.width + x)] = 0.25F;  // 1/sr, white
  addAir(dark.image, dark.camera, dark.info, loaded.scene, 1);
  addAir(lit.image, lit.camera, lit.info, loaded.scene, 1);
  const AirSky sky(loaded.scene.sky, 0.0, loaded.scene.sun.elevation);
  const double above = SlabLight(loaded.scene, 0.0).luminanceAt(*lit.camera.toSky(Vec2(x + 0.5, y + 0.5)));
  // The bands of the air against single nanometres.
  CHECK(lit.luminance(x, y) - dark.luminance(x, y) ==
        doctest::Approx(0.25 * above * sky.sunlight().y / solarIlluminance(loaded.scene.sun.spectrum)).epsilon(0.005));
  const auto i = static_cast<std::size_t>(y * lit.image.width + x);
  const auto halo = [&](std::size_t c) { return (*lit.image.rgb()[c])[i] - (*dark.image.rgb()[c])[i]; };
  CHECK(halo(0) > 1.3F * halo(2));
}

TEST_CASE("below the horizon crystals are seen from the air alone") {
  const auto ofHalo = [](const std::string& altitude) {
    const LoadedScene loaded = smallScene({"sky.air=true", "camera.elevation=-25", altitude});
    Dark dark(loaded), lit(loaded);
    for (Channel& channel : lit.image.channels) channel.samples.assign(channel.samples.size(), 0.25F);
    addAir(dark.image, dark.camera, dark.info, loaded.scene, 1);
    addAir(lit.image, lit.camera, lit.info, loaded.scene, 1);
    return lit.luminance(24, 16) - dark.luminance(24, 16);
  };
  CHECK(ofHalo("observer.altitude=0") == 0.0);
  CHECK(ofHalo("observer.altitude=3000") > 0.0);
}

TEST_CASE("sunlight that reaches the crystals is redder the lower the sun, and as above the air where there is none") {
  const auto white = [](const std::vector<std::string>& overrides) {
    return Spectrum(sunAtCloud(smallScene(overrides).scene).spectrum).white();
  };
  const Vec3 above = white({}), high = white({"sky.air=true", "sun.elevation=60"}),
             low = white({"sky.air=true", "sun.elevation=3"});
  CHECK(high.z < above.z);
  CHECK(low.z < 0.5 * high.z);
  CHECK(low.x > high.x);
  CHECK(white({"sky.air=true", "sun.elevation=-10"}) == above);
}

TEST_CASE("the drawn sun has its true luminance, nearly two thousand million cd/m^2 above the air") {
  const LoadedScene loaded =
      smallScene({"sky.air=true", "sun.visible=true", "sun.elevation=60", "camera.elevation=60",
                  "camera.fov_horizontal=0.3", "observer.altitude=50000", "cloud.optical_depth=1e-6"});
  Dark dark(loaded);
  addAir(dark.image, dark.camera, dark.info, loaded.scene, 1);
  // In the middle the disc is brighter than on the whole, by limb darkening.
  const double middle = Sun(loaded.scene.sun).radiance(0.0);
  const double mean = 1.0 / (2.0 * kPi * (1.0 - std::cos(radians(0.5 * 0.533))));
  CHECK(dark.luminance(24, 16) * mean / middle == doctest::Approx(1.96e9).epsilon(0.03));
}

TEST_CASE("pictures with air say that their white is 1 cd/m^2 and have the same bits for any number of threads") {
  const TemporaryDirectory folder;
  const LoadedScene loaded = smallScene({"sky.air=true", "sun.visible=true"});
  const TracedSky traced = traceSky(loaded, cloudOf(loaded.scene));
  Image one = developSky(traced, loaded, 1).image, four = one;
  writeSky(folder / "one.exr", one, traced.tally.info(), loaded, Gamut::exact, {{}, 1});
  writeSky(folder / "four.exr", four, traced.tally.info(), loaded, Gamut::exact, {{}, 4});
  for (std::size_t c = 0; c < one.channels.size(); ++c) CHECK(one.channels[c].samples == four.channels[c].samples);
  std::ifstream file(folder / "one.exr", std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  CHECK(bytes.find("whiteLuminance") != std::string::npos);
}

TEST_CASE("the sky behind a picture of a million pixels takes half a second of processor time at most") {
  const LoadedScene loaded = parseScene(
      "sky.air = true\nsun.elevation = 20\ncloud.optical_depth = 0.05\n[[population]]\n[camera]\nresolution = "
      "[1024, 1024]",
      "sky.toml");
  Dark dark(loaded);
  const auto costOf = [](const auto& work) {
    const std::clock_t start = std::clock();
    work();
    return double(std::clock() - start) / CLOCKS_PER_SEC;
  };
  // The halo's own light is not of the sky.
  const double cloud = costOf([&] { SlabLight(loaded.scene, 0.0).apply(dark.image, dark.camera); });
  const double all = costOf([&] { addAir(dark.image, dark.camera, dark.info, loaded.scene, 1); });
  CAPTURE(cloud);
  CAPTURE(all);
  CHECK(all - cloud < 0.5);
}
