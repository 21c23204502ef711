// SPDX-License-Identifier: Apache-2.0
// Skies of populations that are integrated and of others that rays are followed for, held against rays alone.
#include "render/mixed_sky.h"

#include <cmath>
#include <stdexcept>

#include <doctest/doctest.h>

#include "parallel/threads.h"
#include "render/traced_sky.h"
#include "scenes.h"
#include "sky/radiance.h"
#include "statistics.h"

using namespace parhelion;
using namespace parhelion::test;

namespace {

/// Plates and random crystals beside Parry crystals, in bins of 5 degrees.
const std::string kDisplay =
    "[sun]\nelevation = 20.0\nspectrum = 550.0\nvisible = false\n"
    "[[population]]\nname = \"plates\"\nweight = 0.5\naspect = 0.3\norientation = \"plate\"\ntilt = 2.0\n"
    "[[population]]\nname = \"parry\"\nweight = 0.3\naspect = 1.5\norientation = \"parry\"\ntilt = 1.0\nroll = 1.0\n"
    "[[population]]\nname = \"random\"\nweight = 0.2\naspect = 1.0\norientation = \"random\"\n"
    "[camera]\nprojection = \"equirectangular\"\nfov_horizontal = 360.0\nresolution = [72, 36]\nelevation = 0.0\n"
    "[recon]\nmethod = \"none\"\n[trace]\nseed = 3\nrays = ";

}  // namespace

TEST_CASE("a mixed sky is that of rays alone") {
  const LoadedScene loaded = parseScene(kDisplay + "\"4M\"\n", "mixed.toml");
  const MixedSky mixed = mixSky(loaded, {0.03});
  CHECK(mixed.integrated == std::vector<std::string>{"plates", "random"});
  CHECK(mixed.traced == std::vector<std::string>{"parry"});
  const Image rays = plainRadiance(traceSky(loaded, cloudByLight(loaded.scene)).tally.flattened());
  const auto &a = *mixed.sky.image.find("G"), &b = *rays.find("G");
  const auto &va = *mixed.sky.image.find(kVarianceChannel), &vb = *rays.find(kVarianceChannel);
  int bins = 0, beyond = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double rayError = std::sqrt(static_cast<double>(vb[i])), light = static_cast<double>(b[i]);
    if (rayError > 0.05 * light) continue;
    // The shares of light are known to a thousandth.
    const double sigma = std::hypot(std::sqrt(static_cast<double>(va[i])), rayError, 1e-3 * light);
    ++bins;
    beyond += std::abs(static_cast<double>(a[i]) - light) > kSigmas * sigma;
  }
  CHECK(bins > 500);
  CHECK(beyond == 0);
}

TEST_CASE("a mixed sky is the same to the bit for any number of threads") {
  const LoadedScene loaded = parseScene(kDisplay + "\"50k\"\n", "mixed.toml");
  TraceControl one, three;
  one.threads = 1;
  three.threads = 3;
  const MixedSky a = mixSky(loaded, {0.2}, one), b = mixSky(loaded, {0.2}, three);
  REQUIRE(a.sky.image.channels.size() == b.sky.image.channels.size());
  for (std::size_t k = 0; k < a.sky.image.channels.size(); ++k)
    CHECK(a.sky.image.channels[k].samples == b.sky.image.channels[k].samples);
}

TEST_CASE("rays of a mixed sky end where the whole picture is good enough") {
  const LoadedScene loaded = parseScene(kDisplay + "\"4M\"\n", "mixed.toml");
  const MixedSky early = mixSky(loaded, {0.2, true}), all = mixSky(loaded, {0.2});
  CHECK(all.sky.info.rayCount() == 4'000'000);
  CHECK(early.sky.info.rayCount() < 1'000'000);
  CHECK(early.sky.reached);
  CHECK(early.sky.error <= 0.2);
  CHECK(all.sky.error < early.sky.error);
  const MixedSky never = mixSky(parseScene(kDisplay + "\"100k\"\n", "mixed.toml"), {1e-3, true});
  CHECK_FALSE(never.sky.reached);
  CHECK(never.sky.error > 1e-3);
}

TEST_CASE("only what cannot be integrated takes rays") {
  LoadedScene loaded = parseScene(kDisplay + "\"50k\"\n", "mixed.toml");
  loaded.scene.trace.engine = Engine::mixed;
  CHECK(raysOf(loaded.scene) == 50000);
  loaded.scene.populations[1].weight = 0.0;
  CHECK(raysOf(loaded.scene) == 0);
  loaded.scene.populations[1].weight = 0.3;
  loaded.scene.populations[1].orientation =
      AxisOrientation{FixedValue{0.5 * kPi}, AxisOrientation{}.azimuth, FixedValue{}};
  CHECK(raysOf(loaded.scene) == 0);
}
