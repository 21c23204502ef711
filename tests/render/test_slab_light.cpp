// SPDX-License-Identifier: Apache-2.0
// Light scattered once in a cloud, against closed forms.
#include "render/slab_light.h"

#include <cmath>

#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStandardAttributes.h>
#include <doctest/doctest.h>

#include "math/rotation.h"
#include "optics/spectrum.h"
#include "picture/temporary_directory.h"
#include "recon/reconstruct.h"
#include "render/sky_files.h"
#include "render/traced_sky.h"
#include "sky/radiance.h"

using namespace parhelion;

namespace {

const std::string kRandom = "[[population]]\naspect = 1.0\norientation = \"random\"\n";

SlabLight slabOf(double sun, double depth, double undeviated, const std::string& populations = kRandom) {
  const std::string text = "[sun]\nelevation = " + std::to_string(sun) + "\nspectrum = 550.0\n[ice]\nindex = 1.31\n" +
                           populations + "[cloud]\noptical_depth = " + std::to_string(depth) + "\n";
  return {parseScene(text, "cloud.toml").scene, undeviated};
}

Vec3 up(double elevation) { return skyDirection(1.0, radians(elevation)); }

constexpr double kUndeviated = 0.2400;

}  // namespace

TEST_CASE("sunlight above the air is 133 klx, and 98 klx at the ground under 1.5 air masses") {
  CHECK(solarIlluminance(ContinuousSpectrum{}) == doctest::Approx(133e3).epsilon(0.01));
  CHECK(solarIlluminance(ContinuousSpectrum{ContinuousSpectrum::Source::airMass1_5}) ==
        doctest::Approx(98e3).epsilon(0.05));
}

TEST_CASE("what passes undeviated is not taken from the sun's beam") {
  const SlabLight slab = slabOf(20.0, 1.0, kUndeviated);
  CHECK(slab.directIlluminance() / solarIlluminance(MonochromaticSpectrum{}) == doctest::Approx(0.1084).epsilon(1e-3));
}

TEST_CASE("a cloud's light of first order is that of the closed form, from below and from above") {
  const double illuminance = solarIlluminance(MonochromaticSpectrum{});
  for (const double depth : {0.01, 0.3, 1.0, 5.0})
    for (const double elevation : {0.3, 5.0, 20.0, 60.0, 90.0, -0.3, -20.0, -70.0}) {
      CAPTURE(depth);
      CAPTURE(elevation);
      const double sunward = std::sin(radians(20.0)), rise = std::abs(std::sin(radians(elevation))),
                   fromSun = depth * (1.0 - kUndeviated) / sunward, toObserver = depth * (1.0 - kUndeviated) / rise;
      double through = elevation == 20.0 ? std::exp(-fromSun)
                                         : (std::exp(-fromSun) - std::exp(-toObserver)) / (toObserver - fromSun);
      if (elevation < 0.0) through = (1.0 - std::exp(-fromSun - toObserver)) / (fromSun + toObserver);
      CHECK(slabOf(20.0, depth, kUndeviated).luminanceAt(up(elevation)) ==
            doctest::Approx(illuminance * depth / rise * through).epsilon(0.01));
    }
}

TEST_CASE("light along the horizon is finite, and there is none of a sun below it") {
  const double level = slabOf(20.0, 0.5, kUndeviated).luminanceAt(Vec3(0.0, 1.0, 0.0));
  CHECK(level == doctest::Approx(slabOf(20.0, 0.5, kUndeviated).luminanceAt(up(-0.001))).epsilon(0.01));
  CHECK(slabOf(-1.0, 0.5, kUndeviated).luminanceAt(up(30.0)) == 0.0);
  CHECK(slabOf(-1.0, 0.5, kUndeviated).directIlluminance() == 0.0);
}

TEST_CASE("crystals of which a scene does not say how many dim no sunlight, wherever the sun stands") {
  for (const double sun : {20.0, 0.1, -0.2}) {
    CAPTURE(sun);
    const std::string text = "[sun]\nelevation = " + std::to_string(sun) + "\nspectrum = 550.0\n" + kRandom;
    const SlabLight slab(parseScene(text, "thin.toml").scene, kUndeviated);
    CHECK(slab.directIlluminance() == solarIlluminance(MonochromaticSpectrum{}));
    const double toObserver = 0.05 * (1.0 - kUndeviated) / std::sin(radians(30.0));
    CHECK(slab.luminanceAt(up(30.0)) ==
          doctest::Approx(solarIlluminance(MonochromaticSpectrum{}) * 0.05 / std::sin(radians(30.0)) *
                          (1.0 - std::exp(-toObserver)) / toObserver)
              .epsilon(1e-3));
  }
}

TEST_CASE("plates take more light from a high sun than from a low one") {
  const std::string plates = "[[population]]\naspect = 0.1\norientation = \"plate\"\n";
  const double low = slabOf(5.0, 0.01, 0.0, plates).luminanceAt(up(60.0)),
               high = slabOf(80.0, 0.01, 0.0, plates).luminanceAt(up(60.0));
  const double basal = 2.598076211353316, sides = 1.2 / kPi;
  const auto shadow = [&](double h) { return basal * std::sin(radians(h)) + sides * std::cos(radians(h)); };
  CHECK(low / high == doctest::Approx(shadow(5.0) / shadow(80.0)).epsilon(0.02));
}

TEST_CASE("the file of a cloud's picture says that its light is in cd/m2") {
  const TemporaryDirectory folder;
  const auto written = [&](const std::string& cloud) {
    const LoadedScene loaded = parseScene(
        kRandom + cloud + "[camera]\nresolution = [8, 8]\n[trace]\nrays = \"2k\"\n[recon]\nmethod = \"none\"\n",
        "file.toml");
    const TracedSky traced = traceSky(loaded, cloudOf(loaded.scene));
    Image image = reconstruct(traced.tally, loaded.scene.recon).image;
    writeSky(folder / "sky.exr", image, traced.tally.info(), loaded, Gamut::exact);
    const Imf::InputFile file((folder / "sky.exr").c_str());
    return Imf::hasWhiteLuminance(file.header()) ? Imf::whiteLuminance(file.header()) : 0.0F;
  };
  CHECK(written("[cloud]\noptical_depth = 0.4\n") == 1.0F);
  CHECK(written("") == 0.0F);
}

TEST_CASE("pictures of a cloud are in cd/m2, layers and errors with them") {
  const LoadedScene loaded = parseScene(
      "layers = \"populations\"\n[[population]]\nname = \"a\"\naspect = 1.0\n[[population]]\nname = \"b\"\naspect = "
      "0.2\n"
      "orientation = \"plate\"\n[camera]\nresolution = [16, 16]\n[cloud]\noptical_depth = 0.4\n[trace]\nrays = "
      "\"20k\"\n"
      "[recon]\nmethod = \"none\"\n",
      "layers.toml");
  const TracedSky traced = traceSky(loaded, cloudOf(loaded.scene));
  const Image before = reconstruct(traced.tally, loaded.scene.recon).image;
  const SlabLight slab(loaded.scene, traced.tally.info().undeviatedFraction());
  Image after = before;
  const Camera camera(loaded.scene.camera);
  slab.apply(after, camera);
  const std::size_t pixel = 16 * 5 + 6;
  const double luminance = slab.luminanceAt(*camera.toSky({6.5, 5.5}));
  REQUIRE(luminance > 0.0);
  for (const char* name : {"R", "G", "B", "a.G", "b.G"}) {
    CAPTURE(name);
    CHECK(static_cast<double>((*after.find(name))[pixel]) ==
          doctest::Approx(luminance * static_cast<double>((*before.find(name))[pixel])).epsilon(1e-6));
  }
  CHECK(static_cast<double>((*after.find(kVarianceChannel))[pixel]) ==
        doctest::Approx(luminance * luminance * static_cast<double>((*before.find(kVarianceChannel))[pixel]))
            .epsilon(1e-6));
}
