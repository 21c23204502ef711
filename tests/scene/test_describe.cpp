// SPDX-License-Identifier: Apache-2.0
#include "scene/describe.h"

#include <doctest/doctest.h>

#include "math/names.h"
#include "scene_support.h"

using namespace parhelion;
using namespace parhelion::test;

TEST_CASE("a summary shows a scene in degrees, one line a population") {
  CHECK(
      describeScene(sceneOf(kExample)) ==
      "sun         elevation 20°, diameter 0.533°, spectrum sun, not drawn\n"
      "ice         index of Warren & Brandt 2008\n"
      "population  plates: 60 % of the surface; prism, aspect 0.1; c axis at zenith angle 0°, normal, sigma 1°; "
      "azimuth free; roll free\n"
      "population  free: 40 % of the surface; prism, aspect 2; c axis at zenith angle 90°; azimuth free; roll 0°, "
      "normal, sigma 5°\n"
      "camera      fisheye-equal-area toward azimuth 0°, elevation 90°, roll 0°; 180° horizontal, 1024 x 1024 pixels\n"
      "trace       10000000 rays, seed 1, engine embree, path split, sampler random, symmetry auto\n"
      "recon       adaptive\n");
}

TEST_CASE("a summary shows lines, constant ice, pyramids and Lowitz orientations") {
  const std::string text = describeScene(sceneOf(
      "sun.spectrum = [450, 650]\nice.index = 1.31\n[[population]]\nshape = 'pyramid'\norientation = 'lowitz'"));
  CHECK(text.find("450, 650 nm") != std::string::npos);
  CHECK(text.find("index 1.31\n") != std::string::npos);
  CHECK(text.find("pyramid, aspect 1, upper 0.5, lower 0.5, slope 28°") != std::string::npos);
  CHECK(text.find("lowitz axis at zenith angle 90°; spin free") != std::string::npos);
}

TEST_CASE("a summary tells spreads through a pole by their signed angles, and a free azimuth by its whole turns") {
  const auto told = [](const std::string& orientation) {
    return describeScene(sceneOf("[[population]]\norientation = " + orientation));
  };
  CHECK(told("{ zenith = { uniform = [-5, 10] }, azimuth = 30 }")
            .find("zenith angle -5° to 10°; azimuth 30°; roll free") != std::string::npos);
  CHECK(told("{ zenith = { laplace = [5, 10] } }").find("zenith angle 5°, laplace, scale 10°; azimuth free") !=
        std::string::npos);
  CHECK(told("{ zenith = 10, azimuth = { uniform = [-40, 350] } }").find("azimuth -40° to 350°") != std::string::npos);
}

TEST_CASE("a summary tells illuminants, black bodies and weighted lines") {
  const auto told = [](const std::string& spectrum) {
    return describeScene(sceneOf("sun.spectrum = " + spectrum + "\n[[population]]"));
  };
  CHECK(told("'D65'").find("spectrum D65") != std::string::npos);
  CHECK(told("{ blackbody = 3000 }").find("black body of 3000 K") != std::string::npos);
  CHECK(told("{ wavelengths = [450, 650], weights = [1, 2.5] }").find("450, 650 nm weighted 1, 2.5") !=
        std::string::npos);
}

TEST_CASE("enumerations have the names that scene files use") {
  CHECK(nameOf(Engine::embreeRobust) == "embree-robust");
  CHECK(nameOf(PathMode::split) == "split");
  CHECK(nameOf(ReconSettings{}) == "adaptive");
  CHECK(nameOf(Projection::fisheyeEqualArea) == "fisheye-equal-area");
}
