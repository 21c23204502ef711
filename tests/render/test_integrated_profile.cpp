// SPDX-License-Identifier: Apache-2.0
// Integrated profiles of light that took some raypaths alone, held against rays and against all light.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>

#include "render/integrated_profile.h"
#include "render/traced_sky.h"
#include "statistics.h"
#include "trace/trace.h"

using namespace parhelion;

namespace {

const std::string kLight = "[sun]\nspectrum = 550.0\n[ice]\nindex = 1.31\n";
const std::string kColumns = kLight + "[[population]]\nname = \"columns\"\naspect = 2.0\norientation = \"random\"\n";
const std::string kTwoKinds = kLight +
                              "[[population]]\nname = \"short\"\naspect = 0.5\norientation = \"random\"\nweight = 2.0\n"
                              "[[population]]\nname = \"long\"\naspect = 2.0\norientation = \"random\"\n";

Scene sceneOf(const std::string& text, const std::string& filter = "") {
  const std::string trace = "[trace]\nseed = 5\nrays = \"2M\"\n";
  return parseScene(text + trace + (filter.empty() ? "" : "filter = '" + filter + "'\n"), "profile.toml").scene;
}

IntegratedProfile integrated(const Scene& scene, double error, int bins, double from = 0.0, double to = 180.0) {
  REQUIRE(objectionToIntegral(scene).empty());
  return integrateProfile(scene, {bins, radians(from), radians(to), error, true});
}

struct Traced {
  ScatterProfile profile;
  TraceReport report;
};

Traced traced(const Scene& scene, int bins) {
  Traced result{ScatterProfile(bins, 0.0, kPi), {}};
  TraceSettings settings = scene.trace;
  settings.symmetry = Symmetry::none;
  result.report = traceRays(cloudByLight(scene), settings, 0, result.profile);
  return result;
}

/// That a share of the light, which rays bring all at once, is what they find, to so many sigmas of its own noise.
void checkShare(double integral, double rays, std::uint64_t count) {
  const double noise = std::sqrt(std::max(rays, 1e-7) / static_cast<double>(count));
  CHECK(std::abs(integral - rays) < kSigmas * noise + 1e-5);
}

}  // namespace

TEST_CASE("rays agree with integrated profiles of light that took some raypaths") {
  constexpr int kBins = 90;
  for (const std::string filter : {"3-5", "1-3", "not 3-5", "3-*-5", "1-3|3, symmetry = none"}) {
    CAPTURE(filter);
    const Scene scene = sceneOf(kTwoKinds, filter);
    const IntegratedProfile integral = integrated(scene, 0.02, kBins);
    const Traced rays = traced(scene, kBins);
    const std::vector<ScatterProfile::Bin> bins = rays.profile.bins();
    int compared = 0;
    double chiSquare = 0.0;
    for (std::size_t k = 0; k < kBins; ++k) {
      if (bins[k].energy == 0.0) {
        CHECK(integral.bins[k].energy < 1e-6);
        continue;
      }
      // Few hits of unequal light are not spread as sigmas say.
      if (bins[k].error > 0.05 * bins[k].energy) continue;
      const double apart =
          (integral.bins[k].energy - bins[k].energy) / std::hypot(bins[k].error, integral.bins[k].error);
      CHECK(std::abs(apart) < kSigmas);
      chiSquare += apart * apart;
      ++compared;
    }
    CHECK(compared > 8);
    CHECK(chiSquare < compared + kSigmas * std::sqrt(2.0 * compared));

    const ScatterProfile::Summary a = integral.summary, b = rays.profile.summary();
    CHECK(std::abs(a.g - b.g) < kSigmas * std::hypot(a.gError, b.gError));
    CHECK(std::abs(a.meanPath - b.meanPath) < kSigmas * std::hypot(a.meanPathError, b.meanPathError));
    checkShare(a.undeviated, b.undeviated, b.rays);
    for (std::size_t order = 0; order < std::min<std::size_t>(b.byOrder.size(), 8); ++order)
      checkShare(a.byOrder[order], b.byOrder[order], b.rays);
    checkShare(a.byOrderRest, b.byOrderRest, b.rays);
    checkShare(integral.filtered, rays.report.energy.filtered.value() / rays.report.energy.in.value(), b.rays);
  }
}

TEST_CASE("what a pattern takes and what it leaves are all light") {
  constexpr int kBins = 180;
  const IntegratedProfile all = integrated(sceneOf(kColumns), 0.02, kBins);
  CHECK(all.filtered == 0.0);
  for (const std::string pattern : {"3-5", "1-3|3-1", "*-basal-*"}) {
    CAPTURE(pattern);
    const IntegratedProfile taken = integrated(sceneOf(kColumns, pattern), 0.02, kBins),
                            left = integrated(sceneOf(kColumns, "not " + pattern), 0.02, kBins);
    double apart = 0.0;
    for (std::size_t k = 0; k < kBins; ++k) {
      const double off = taken.bins[k].energy + left.bins[k].energy - all.bins[k].energy;
      const double error = std::hypot(taken.bins[k].error, left.bins[k].error, all.bins[k].error);
      CHECK(std::abs(off) < kSigmas * error + 1e-9);
      apart += std::abs(off);
    }
    CHECK(apart < 0.01);
    CHECK(taken.filtered + left.filtered == doctest::Approx(1.0).epsilon(1e-4));
    CHECK(taken.summary.external + left.summary.external == doctest::Approx(all.summary.external).epsilon(1e-6));
    for (std::size_t order = 1; order < 10; ++order)
      CHECK(taken.summary.byOrder[order] + left.summary.byOrder[order] ==
            doctest::Approx(all.summary.byOrder[order]).epsilon(5e-3).scale(1e-4));
  }
}

TEST_CASE("one of the paths that are alike in random crystals has its share of their light") {
  constexpr int kBins = 45;
  // Of either kind there are twelve.
  for (const std::string pattern : {"3-5", "1-3"}) {
    CAPTURE(pattern);
    const IntegratedProfile all = integrated(sceneOf(kColumns, pattern), 0.01, kBins),
                            one = integrated(sceneOf(kColumns, pattern + ", symmetry = none"), 0.01, kBins);
    double light = 0.0;
    for (std::size_t k = 0; k < kBins; ++k) {
      const double error = std::hypot(all.bins[k].error, 12.0 * one.bins[k].error);
      CHECK(std::abs(all.bins[k].energy - 12.0 * one.bins[k].energy) < kSigmas * error + 1e-9);
      light += all.bins[k].energy;
    }
    CHECK(light > 0.01);
    CHECK(1.0 - one.filtered == doctest::Approx((1.0 - all.filtered) / 12.0).epsilon(1e-3));
  }
}

TEST_CASE("light of wedges begins at their least deviation") {
  // At n = 1.31, for 60 and 90 degrees; there is nothing before it.
  constexpr int kBins = 40;
  for (const auto& [pattern, edge] : {std::pair("3-5", 21.839), std::pair("1-3", 45.733)}) {
    CAPTURE(pattern);
    const IntegratedProfile profile = integrated(sceneOf(kColumns, pattern), 0.01, kBins, edge - 0.2, edge + 0.2);
    double most = 0.0;
    for (const auto& bin : profile.bins) most = std::max(most, bin.energy);
    int risen = 0;
    while (profile.bins[static_cast<std::size_t>(risen)].energy < 0.5 * most) ++risen;
    CHECK(std::abs(risen - 20) <= 1);
    for (int k = 0; k < 19; ++k) CHECK(profile.bins[static_cast<std::size_t>(k)].energy < 1e-3 * most);
  }
}

TEST_CASE("the red light inside the rings of a white sun is as bright as rays have it") {
  // It is a small part of all light: a few indices for all of it would be a few rings.
  const std::string columns = kColumns.substr(kLight.size());
  for (const double first : {21.4, 45.2}) {
    CAPTURE(first);
    constexpr int kBins = 8;
    const Scene scene = sceneOf("[sun]\nspectrum = \"sun\"\n" + columns);
    const IntegratedProfile integral = integrated(scene, 0.03, kBins, first, first + 0.8);
    ScatterProfile rays(kBins, radians(first), radians(first + 0.8));
    TraceSettings settings = scene.trace;
    settings.symmetry = Symmetry::none;
    traceRays(cloudByLight(scene), settings, 0, rays);
    const std::vector<ScatterProfile::Bin> bins = rays.bins();
    for (std::size_t k = 0; k < kBins; ++k)
      CHECK(std::abs(integral.bins[k].energy - bins[k].energy) < kSigmas * bins[k].error + 0.04 * bins[k].energy);
  }
}

TEST_CASE("crystals that absorb, are distorted or diffract are not integrated, and it is said why") {
  const auto objection = [](const std::string& ice, const std::string& keys) {
    return objectionToIntegral(sceneOf(kLight + ice + "[[population]]\nname = \"p\"\n" + keys));
  };
  CHECK(objection("", "").empty());
  CHECK(objection("absorption = false\n", "size = 30\ndiffraction = false\ndistortion = 0\n").empty());
  CHECK(objection("absorption = 1e-6\n", "size = 30\n") == "population p absorbs light");
  CHECK(objection("", "distortion = 1\n") == "population p has faces that are tilted by chance");
  CHECK(objection("", "size = 30\ndiffraction = true\n") == "population p spreads light by diffraction");
}
