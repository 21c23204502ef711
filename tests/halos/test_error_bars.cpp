// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "picture/colour_space.h"
#include "recon/reconstruct.h"
#include "render/traced_sky.h"
#include "scene/parse_scene.h"
#include "sky/camera.h"
#include "sky/radiance.h"

using namespace parhelion;

namespace {

/// Pixels whose error is below 1, 2 and 3 of the standard errors that the picture claims.
struct Coverage {
  std::array<int, 3> within{};
  int pixels = 0;

  void add(double error, double claimed) {
    for (std::size_t k = 0; k < within.size(); ++k)
      if (std::abs(error) <= (static_cast<double>(k) + 1.0) * claimed) ++within[k];
    ++pixels;
  }
  double percent(std::size_t k) const { return 100.0 * within[k] / pixels; }
};

struct SkyCoverage {
  Coverage all, besideSun, rings;  // up to 12 degrees from the sun, and 1 degree beside the inner edges of 22 and 46
};

LoadedScene sceneOf(const std::string& name, std::uint64_t rays, std::uint64_t seed) {
  const std::vector<std::string> overrides = {"camera.resolution=[128,128]", "trace.rays=" + std::to_string(rays),
                                              "trace.seed=" + std::to_string(seed)};
  return loadScene(std::filesystem::path(PARHELION_SOURCE_DIR) / "scenes" / name, overrides);
}

SkyTally tallyOf(const LoadedScene& loaded) { return traceSky(loaded, cloudOf(loaded.scene)).tally; }

std::vector<double> luminance(const Image& image) {
  const auto [red, green, blue] = image.rgb();
  std::vector<double> result(image.pixels());
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = glm::dot(kRec709Luminance, Vec3{(*red)[i], (*green)[i], (*blue)[i]});
  return result;
}

/// Compares the picture of a few rays with that of very many, whose own noise is counted in.
void addCoverage(SkyCoverage& coverage, const SkyTally& few, const Image& many) {
  const Image picture = reconstruct(few, AdaptiveSettings{}).image;
  const Camera camera(few.info().camera);
  const Vec3 toSun(std::cos(few.info().sunElevation), 0.0, std::sin(few.info().sunElevation));
  const std::vector<double> measured = luminance(picture), truth = luminance(many);
  const std::vector<float>&variance = *picture.find(kVarianceChannel), &bias = *picture.find(kBiasChannel);
  const std::vector<float>& noise = *many.find(kVarianceChannel);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const int x = static_cast<int>(i) % picture.width, y = static_cast<int>(i) / picture.width;
    if (camera.solidAngle(x, y) <= 0.0) continue;
    const double error = measured[i] - truth[i];
    const double claimed = std::sqrt(static_cast<double>(variance[i]) + std::pow(static_cast<double>(bias[i]), 2) +
                                     static_cast<double>(noise[i]));
    coverage.all.add(error, claimed);
    const auto toSky = camera.directionAt({x + 0.5, y + 0.5});
    if (!toSky) continue;
    const double fromSun = degrees(std::acos(std::clamp(glm::dot(*toSky, toSun), -1.0, 1.0)));
    if (fromSun < 12.0) coverage.besideSun.add(error, claimed);
    if (std::abs(fromSun - 21.9) < 1.0 || std::abs(fromSun - 45.9) < 1.0) coverage.rings.add(error, claimed);
  }
}

/// `slack` is what chance may take off, in percent.
template <class F>
void check(const std::string& scene, std::uint64_t rays, const char* where, const Coverage& coverage, const F& slack) {
  char row[200];
  std::snprintf(row, sizeof row, "coverage: | %s | %g | %s | %.0f | %.0f | %.1f |", scene.c_str(),
                static_cast<double>(rays), where, coverage.percent(0), coverage.percent(1), coverage.percent(2));
  MESSAGE(row);
  constexpr std::array<double, 3> kLeast = {63.0, 90.0, 98.5};
  for (std::size_t k = 0; k < kLeast.size(); ++k) CHECK(coverage.percent(k) >= kLeast[k] - slack(kLeast[k], coverage));
}

double none(double, const Coverage&) { return 0.0; }

/// Two standard deviations of the share of a region. It is mirrored, so half its pixels are independent.
double twoSigmas(double percent, const Coverage& coverage) {
  return 2.0 * std::sqrt(percent * (100.0 - percent) / (0.5 * coverage.pixels));
}

void checkScene(const std::string& scene) {
  const Image many = plainRadiance(tallyOf(sceneOf(scene, 20'000'000, 99)).flattened());
  struct Run {
    std::uint64_t rays;
    int seeds;
  };
  for (const auto& [rays, seeds] : {Run{100'000, 8}, Run{1'000'000, 4}, Run{4'000'000, 3}}) {
    SkyCoverage coverage;
    for (int seed = 1; seed <= seeds; ++seed)
      addCoverage(coverage, tallyOf(sceneOf(scene, rays, static_cast<std::uint64_t>(seed))), many);
    check(scene, rays, "whole sky", coverage.all, none);
    check(scene, rays, "beside the sun", coverage.besideSun, twoSigmas);
    check(scene, rays, "rings' edges", coverage.rings, twoSigmas);
  }
}

}  // namespace

TEST_CASE(
    "errors of a display of three populations are within one, two, three of the claimed ones as often as normal") {
  checkScene("reconstruction-reference.toml");
}

TEST_CASE("errors of a grand display are within one, two, three of the claimed ones as often as normal") {
  checkScene("display.toml");
}

TEST_CASE("errors of plates and pencils are within one, two, three of the claimed ones as often as normal") {
  checkScene("plates-and-pencils.toml");
}

TEST_CASE(
    "the sum over a radial picture scatters 13.7 times what independent pixels would, for pixels of a ring err alike") {
  constexpr int kRuns = 32;
  double mean = 0.0, squares = 0.0, claimed = 0.0;
  for (int run = 1; run <= kRuns; ++run) {
    const Image image =
        plainRadiance(tallyOf(sceneOf("random-columns.toml", 200'000, static_cast<std::uint64_t>(run))).flattened());
    double sum = 0.0;
    for (const double l : luminance(image)) sum += l;
    for (const float v : *image.find(kVarianceChannel)) claimed += static_cast<double>(v) / kRuns;
    mean += sum / kRuns;
    squares += sum * sum / kRuns;
  }
  const double scatter = std::sqrt((squares - mean * mean) * kRuns / (kRuns - 1) / claimed);
  CHECK(std::abs(scatter / 13.7 - 1.0) < 3.0 / std::sqrt(2.0 * kRuns));  // 3 sigma of a standard deviation
}
