// SPDX-License-Identifier: Apache-2.0
// Integrated skies of some raypaths alone, and in layers by them, held against rays.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "recon/reconstruct.h"
#include "render/integrated_sky.h"
#include "render/mixed_sky.h"
#include "render/traced_sky.h"
#include "sky/radiance.h"
#include "statistics.h"

using namespace parhelion;

namespace {

/// Bins of 5 degrees over the whole sphere.
const std::string kBins =
    "[camera]\nprojection = \"equirectangular\"\nfov_horizontal = 360.0\nresolution = [72, 36]\n"
    "elevation = 0.0\n[recon]\nmethod = \"none\"\n[trace]\nseed = 9\nrays = \"2M\"\n";

const std::string kPlates = "[[population]]\nname = \"plates\"\naspect = 0.3\norientation = \"plate\"\ntilt = 2.0\n";
const std::string kAtRest = "[[population]]\nname = \"still\"\naspect = 2.0\norientation = \"column\"\ntilt = 0.0\n";
const std::string kColumns = "[[population]]\nname = \"columns\"\naspect = 2.0\norientation = \"column\"\ntilt = 1.5\n";
const std::string kRandom = "[[population]]\nname = \"random\"\naspect = 1.0\norientation = \"random\"\n";
const std::string kParry =
    "[[population]]\nname = \"parry\"\naspect = 1.5\norientation = \"parry\"\ntilt = 1.0\nroll = 1.0\n";

std::string sun(double elevation, const std::string& diameter = "0.533") {
  return "[sun]\nelevation = " + std::to_string(elevation) + "\ndiameter = " + diameter +
         "\nspectrum = 550.0\nvisible = false\n";
}

LoadedScene withFilter(const std::string& scene, const std::string& filter) {
  return parseScene(scene + kBins + "filter = '" + filter + "'\n", "filtered.toml");
}

struct Agreement {
  int bins = 0, beyond = 0;  // those with light, and those that differ by more than 4.5 sigma
  double light = 0.0, worst = 0.0;
};

/// A channel of two pictures; the first's errors are those of all its light together, of which this is part.
Agreement agreementOf(const Image& integral, const Image& rays, const std::string& channel,
                      const std::vector<float>& raysVariance) {
  const auto &a = *integral.find(channel), &b = *rays.find(channel);
  const auto& variance = *integral.find(kVarianceChannel);
  Agreement result;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double light = static_cast<double>(b[i]), own = static_cast<double>(a[i]);
    result.light += light;
    // Few hits of unequal light are not spread as sigmas say.
    const double ofRays = std::sqrt(static_cast<double>(raysVariance[i]));
    if (ofRays == 0.0 || ofRays > 0.05 * light) continue;
    const double apart = std::abs(own - light) / std::hypot(ofRays, std::sqrt(static_cast<double>(variance[i])));
    ++result.bins;
    result.beyond += apart > kSigmas;
    result.worst = std::max(result.worst, apart);
  }
  return result;
}

Agreement filtered(const std::string& scene, const std::string& filter) {
  const LoadedScene loaded = withFilter(scene, filter);
  REQUIRE(objectionToIntegratedSky(loaded.scene).empty());
  const IntegratedSky integral = integrateSky(loaded, 0.03);
  const Image rays = plainRadiance(traceSky(loaded, cloudByLight(loaded.scene)).tally.flattened());
  return agreementOf(integral.image, rays, "G", *rays.find(kVarianceChannel));
}

void checkFilters(const std::string& scene, const std::vector<std::string>& filters, int fewestBins) {
  for (const std::string& filter : filters) {
    CAPTURE(scene);
    CAPTURE(filter);
    const Agreement agreement = filtered(scene, filter);
    CAPTURE(agreement.worst);
    CHECK(agreement.bins >= fewestBins);
    CHECK(agreement.beyond == 0);
  }
}

}  // namespace

TEST_CASE("rays agree with integrated skies of plates whose light took some raypaths") {
  checkFilters(sun(20.0) + kPlates, {"3-5", "1-3", "not 3-5", "3-*-5"}, 5);
  // Under a sun so low light meets the lower ends of some plates, the upper ones of others.
  checkFilters(sun(1.0) + kPlates, {"1-3|3-1-5"}, 5);
}

TEST_CASE("rays agree with integrated skies of columns whose light took some raypaths") {
  checkFilters(sun(30.0) + kColumns, {"3-5", "22° halo|upper tangent arc"}, 5);
  checkFilters(sun(45.0, "0.0") + kAtRest, {"3-5", "1-3|3-1-5"}, 5);
}

TEST_CASE("rays agree with integrated skies of Parry columns whose light took some raypaths") {
  const std::string still = "[[population]]\nname = \"still\"\naspect = 1.2\norientation = \"parry\"\n";
  checkFilters(sun(25.3, "0.0") + still, {"Parry arc", "not 6-3"}, 5);
  // Of a crystal whose rolls are not all alike, one side by itself.
  checkFilters(sun(25.3) + still, {"6-4, symmetry = none"}, 5);
}

TEST_CASE("rays agree with integrated skies of random crystals whose light took some raypaths") {
  checkFilters(sun(10.0) + kRandom, {"3-5", "1-3", "1-2-1", "*-basal-*"}, 20);
}

TEST_CASE("layers of an integrated sky are those of rays, and add up to it") {
  const std::string layers =
      "[[layer]]\nname = \"wedge\"\npaths = \"3-5\"\n[[layer]]\nname = \"ends\"\npaths = \"1-3\"\npopulations = "
      "[\"plates\"]\n[[layer]]\nname = \"random\"\npopulations = [\"random\"]\n";
  const LoadedScene loaded = parseScene(sun(15.0) + kPlates + kRandom + kColumns + layers + kBins, "layers.toml");
  const IntegratedSky integral = integrateSky(loaded, 0.03);
  const TracedSky traced = traceSky(loaded, cloudByLight(loaded.scene));
  const ReconstructedSky rays = reconstruct(traced.tally, loaded.scene.recon);
  std::vector<float> sum(integral.image.find("G")->size());
  for (const std::string layer : {"wedge", "ends", "random", "rest"}) {
    CAPTURE(layer);
    std::size_t k = 0;
    while (traced.tally.layers()[k] != layer) ++k;
    std::vector<float> variance(sum.size());
    for (std::size_t s = 0; s < traced.tally.symmetries().size(); ++s) {
      const Image part = plainRadiance(traced.tally.parts()[k * traced.tally.symmetries().size() + s].tally);
      for (std::size_t i = 0; i < sum.size(); ++i) variance[i] += (*part.find(kVarianceChannel))[i];
    }
    const Agreement agreement = agreementOf(integral.image, rays.image, layer + ".G", variance);
    CAPTURE(agreement.worst);
    CHECK(agreement.light > 0.0);
    CHECK(agreement.bins > 5);
    CHECK(agreement.beyond == 0);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += (*integral.image.find(layer + ".G"))[i];
  }
  const auto& all = *integral.image.find("G");
  for (std::size_t i = 0; i < sum.size(); ++i)
    CHECK(static_cast<double>(sum[i]) == doctest::Approx(static_cast<double>(all[i])).epsilon(1e-6).scale(1e-6));
}

TEST_CASE("layers of a mixed sky hold what was integrated and what rays brought, and add up to it") {
  const std::string layers =
      "[[layer]]\nname = \"wedge\"\npaths = \"3-5\"\n[[layer]]\nname = \"parry\"\npopulations = [\"parry\"]\n"
      "[[layer]]\nname = \"plates\"\npopulations = [\"plates\"]\n";
  const LoadedScene loaded = parseScene(sun(20.0) + kPlates + kParry + layers + kBins, "mixed.toml");
  const MixedSky mixed = mixSky(loaded, {0.03});
  CHECK(mixed.integrated == std::vector<std::string>{"plates"});
  CHECK(mixed.traced == std::vector<std::string>{"parry"});
  const TracedSky traced = traceSky(loaded, cloudByLight(loaded.scene));
  const Image rays = reconstruct(traced.tally, loaded.scene.recon).image;
  std::vector<float> sum(rays.find("G")->size());
  for (const std::string layer : {"wedge", "parry", "plates", "rest"}) {
    CAPTURE(layer);
    const auto &own = *mixed.sky.image.find(layer + ".G"), &theirs = *rays.find(layer + ".G");
    double light = 0.0, traces = 0.0;
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum[i] += own[i];
      light += static_cast<double>(own[i]);
      traces += static_cast<double>(theirs[i]);
    }
    CHECK(light == doctest::Approx(traces).epsilon(0.02));
  }
  const auto& all = *mixed.sky.image.find("G");
  for (std::size_t i = 0; i < sum.size(); ++i)
    CHECK(static_cast<double>(sum[i]) == doctest::Approx(static_cast<double>(all[i])).epsilon(1e-6).scale(1e-6));
}

TEST_CASE("light that goes straight on counts only if its path is wanted") {
  const auto undeviated = [](const std::string& filter) {
    const LoadedScene loaded = withFilter(sun(32.0) + kPlates, filter);
    const double traced = traceSky(loaded, cloudByLight(loaded.scene)).tally.info().undeviatedFraction();
    CHECK(integrateSky(loaded, 0.1).info.undeviatedFraction() == doctest::Approx(traced).epsilon(0.01));
    return traced;
  };
  CHECK(undeviated("1-2") > 0.1);
  CHECK(undeviated("3-5") == 0.0);
}

TEST_CASE("one more population is followed by rays where its paths are told apart by sides that are alike") {
  const LoadedScene loaded = withFilter(sun(20.0) + kPlates, "3-5, symmetry = none");
  CHECK(objectionToIntegratedSky(loaded.scene).find("plates") != std::string::npos);
  CHECK_THROWS_AS(integrateSky(loaded, 0.1), std::invalid_argument);
  LoadedScene mixed = loaded;
  mixed.scene.trace.engine = Engine::mixed;
  CHECK(raysOf(mixed.scene) == 2'000'000);
}

TEST_CASE("a layer by tilts is followed by rays") {
  const std::string tilted = "[[layer]]\nname = \"upright\"\ntilt = [0, 2]\npopulations = [\"plates\"]\n";
  const LoadedScene loaded = parseScene(sun(20.0) + kPlates + kRandom + tilted + kBins, "tilts.toml");
  CHECK(objectionToIntegratedSky(loaded.scene).find("upright") != std::string::npos);
}
