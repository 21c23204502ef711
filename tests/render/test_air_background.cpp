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

namespace {

/// The light of an even halo of 0.25 1/sr in a pixel of a scene with air, and of the sky without it.
struct OfAirAndHalo {
  OfAirAndHalo(const std::vector<std::string>& overrides, int x, int y) {
    const LoadedScene loaded = smallScene(overrides);
    Dark dark(loaded), lit(loaded);
    for (Channel& channel : lit.image.channels) channel.samples.assign(channel.samples.size(), 0.25F);
    addAir(dark.image, dark.camera, dark.info, loaded.scene, 1);
    addAir(lit.image, lit.camera, lit.info, loaded.scene, 1);
    sky = dark.luminance(x, y);
    halo = lit.luminance(x, y) - sky;
  }
  double sky, halo;
};

}  // namespace

TEST_CASE(
    "a cloud high up is lit by whiter sunlight, and seen through the air below it, most of which dims the horizon") {
  const std::vector<std::string> plain{
      "sky.air=true",        "sky.aerosol=0",           "sky.ozone=0", "cloud.optical_depth=1e-4", "sun.elevation=40",
      "camera.elevation=90", "camera.fov_horizontal=10"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), plain.begin(), plain.end());
    return more;
  };
  // In the zenith: sunlight gets 1/sin 40 of the depth of molecules above the cloud, and the cloud's light that below.
  const double here = OfAirAndHalo(plain, 24, 16).halo;
  const double there = OfAirAndHalo(with({"cloud.altitude=8000"}), 24, 16).halo;
  const double depth = 0.0973, below = depth * (1.0 - std::exp(-1.0));  // at 550 nm
  CHECK(there / here == doctest::Approx(std::exp(below / std::sin(radians(40.0)) - below)).epsilon(0.01));
  // Near the horizon, from within 2 m of the crystals and from 8 km below them.
  const std::vector<std::string> low{"camera.elevation=6"};
  const double lowHere = OfAirAndHalo(with(low), 24, 16).halo,
               lowThere = OfAirAndHalo(with({"camera.elevation=6", "cloud.altitude=8000"}), 24, 16).halo;
  CHECK(lowThere / lowHere < 0.75 * there / here);
  CHECK(OfAirAndHalo(with({"cloud.altitude=0"}), 24, 16).halo == doctest::Approx(here).epsilon(1e-3));
}

TEST_CASE(
    "a thin cloud hides nothing of the sky, at whatever altitude; before a deep one is the light of the air alone") {
  const std::vector<std::string> plain{"sky.air=true", "camera.elevation=12", "camera.fov_horizontal=10"};
  const auto skyWith = [&](const std::string& depth, const std::string& altitude) {
    std::vector<std::string> all{plain};
    all.push_back("cloud.optical_depth=" + depth);
    if (!altitude.empty()) all.push_back("cloud.altitude=" + altitude);
    return OfAirAndHalo(all, 24, 16).sky;
  };
  const double clear = skyWith("1e-9", "");
  for (const char* altitude : {"0", "300", "3000", "12000", "50000"})
    CHECK(skyWith("1e-9", altitude) == doctest::Approx(clear).epsilon(1e-4));
  // All the air is before a cloud above it, and is lit by less than the whole sun.
  CHECK(skyWith("3", "50000") < clear);
  CHECK(skyWith("3", "50000") > 0.3 * clear);
}

TEST_CASE("from above a cloud is seen below the horizon alone, and from below above it") {
  const std::vector<std::string> plain{"sky.air=true", "cloud.optical_depth=0.3", "camera.fov_horizontal=10"};
  const auto haloAt = [&](const char* elevation, const char* observer) {
    std::vector<std::string> all{plain};
    for (const std::string& more : {std::string("cloud.altitude=9000"), std::string("camera.elevation=") + elevation,
                                    std::string("observer.altitude=") + observer})
      all.push_back(more);
    return OfAirAndHalo(all, 24, 16).halo;
  };
  CHECK(haloAt("20", "11000") == 0.0);
  CHECK(haloAt("-20", "11000") > 0.0);
  CHECK(haloAt("20", "5000") > 0.0);
  CHECK(haloAt("-20", "5000") == 0.0);
  // It ends at the dip of its edge, 1.4 degrees for 2 km above it.
  CHECK(haloAt("-1", "11000") == 0.0);
  CHECK(haloAt("-1.8", "11000") > 0.0);
  // In the midst of it.
  CHECK(haloAt("20", "9000") > 0.0);
  CHECK(haloAt("-20", "9000") > 0.0);
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
