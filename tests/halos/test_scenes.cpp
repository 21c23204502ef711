// SPDX-License-Identifier: Apache-2.0
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "halos/edge_fit.h"
#include "render/traced_sky.h"
#include "scene/parse_scene.h"
#include "trace/expose.h"

using namespace parhelion;

namespace {

const std::filesystem::path kScenes = std::filesystem::path(PARHELION_SOURCE_DIR) / "scenes";

/// What a scene's header says, measured in all its light; degrees.
struct Claim {
  enum class What {
    ring,         // inner edge `where` from the sun
    inVertical,   // brightest at elevation `where` within 1.5 degrees of it, in the sun's vertical
    atElevation,  // brightest at azimuth `where` within 5 degrees of it, at elevation `elevation`, on both sides
  } what;
  double where;
  double elevation = 0.0;
};
using What = Claim::What;

struct SceneClaims {
  std::string file;
  std::vector<Claim> claims;
};

const SceneClaims kClaims[] = {
    {"random-columns.toml", {{What::ring, 21.9}, {What::ring, 45.9}}},
    {"parhelia.toml", {{What::atElevation, 24.7, 20}, {What::atElevation, 120, 20}, {What::inVertical, 66.1}}},
    {"environment.toml",
     {{What::ring, 21.9}, {What::atElevation, 24.7, 20}, {What::inVertical, 66.1}, {What::inVertical, 41.9}}},
    {"reconstruction-reference.toml", {{What::atElevation, 25.1, 20}, {What::inVertical, 42.3}}},
    {"tangent-arcs.toml", {{What::inVertical, 41.9}}},
    {"circumscribed.toml", {{What::inVertical, 66.9}, {What::inVertical, 23.1}, {What::atElevation, 40.5, 45}}},
    {"parry.toml", {{What::inVertical, 48.8}, {What::inVertical, 41.9}}},
    {"lowitz.toml", {{What::atElevation, 24.7, 20}}},
    {"sun-pillar.toml", {{What::inVertical, -5}}},
    {"circumhorizontal.toml", {{What::inVertical, 18.7}, {What::ring, 21.9}}},
    {"pyramids.toml",
     {{What::ring, 9.0},
      {What::ring, 18.3},
      {What::ring, 20.0},
      {What::ring, 22.9},
      {What::ring, 23.9},
      {What::ring, 35.1}}},
    {"display.toml",
     {{What::ring, 21.9},
      {What::atElevation, 25.6, 23},
      {What::atElevation, 120, 23},
      {What::inVertical, 44.9},
      {What::inVertical, 50.4},
      {What::inVertical, 69.0}}},
    {"hollow-columns.toml", {{What::inVertical, 46.9}}},
    {"bullet-rosettes.toml", {{What::ring, 9.0}, {What::ring, 20.0}, {What::ring, 21.9}, {What::ring, 35.1}}},
    {"capped-columns.toml", {{What::atElevation, 24.7, 20}, {What::inVertical, 66.1}, {What::inVertical, 41.9}}},
    {"sector-plates.toml", {{What::atElevation, 10.2, 20}, {What::atElevation, 17.9, 20}, {What::inVertical, 66.1}}},
    {"sheaths.toml", {{What::inVertical, 46.9}}},
    {"kern-arc.toml", {{What::inVertical, 62.4}}},
    {"cubic-ice.toml", {{What::ring, 27.9}, {What::ring, 21.9}}},
    {"co2-halo.toml", {{What::ring, 26.3}, {What::ring, 29.9}, {What::ring, 38.9}}},
    {"moilanen.toml", {{What::inVertical, 16.5}, {What::ring, 21.9}}},
    {"evening.toml", {{What::ring, 21.9}, {What::atElevation, 22.2, 7}, {What::inVertical, 28.9}}},
    {"diamond-dust.toml", {{What::atElevation, 22.6, 10}}},
    {"winter-morning.toml", {{What::ring, 21.9}, {What::atElevation, 22.1, 4}}},
    {"thin-to-thick.toml", {{What::ring, 21.9}, {What::atElevation, 26.4, 25}, {What::inVertical, 46.9}}},
    {"subsun.toml", {{What::inVertical, -25}, {What::atElevation, 27.0, -25}}},
    {"blue-noon.toml", {{What::ring, 21.9}, {What::atElevation, 26.4, 25}}},
    {"plates-and-pencils.toml",
     {{What::atElevation, 26.4, 25}, {What::inVertical, 71.3}, {What::inVertical, 46.9}, {What::inVertical, 3.1}}},
};

Histogram around(const Claim& claim) {
  switch (claim.what) {
    case What::ring:
      return {claim.where - 0.6, claim.where + 0.6, 120};
    case What::inVertical:
      return {claim.where - 1.5, claim.where + 1.5, 20};
    case What::atElevation:
      return {claim.where - 5.0, claim.where + 5.0, 40};
  }
  return {0, 1, 1};
}

void addExit(const Claim& claim, const LightPath& path, const Exit& exit, Histogram& histogram) {
  if (exit.undeviated) return;
  const SkyDegrees sky = seenAt(exit.lightDirWorld);
  if (claim.what == What::ring)
    histogram.add(degrees(angleBetween(path.incident.lightDirWorld, exit.lightDirWorld)), exit.energy);
  else if (claim.what == What::inVertical && std::abs(sky.azimuth) < 1.0)
    histogram.add(sky.elevation, exit.energy);
  else if (claim.what == What::atElevation && std::abs(sky.elevation - claim.elevation) < 0.5)
    histogram.add(std::abs(sky.azimuth), exit.energy);
}

std::set<std::string> sceneFiles() {
  std::set<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(kScenes))
    if (entry.path().extension() == ".toml") files.insert(entry.path().filename().string());
  return files;
}

}  // namespace

TEST_CASE("every scene in scenes/ names the schema, tells what it shows and loads") {
  std::set<std::string> claimed;
  for (const SceneClaims& scene : kClaims) claimed.insert(scene.file);
  CHECK(claimed == sceneFiles());

  for (const std::string& file : sceneFiles()) {
    CAPTURE(file);
    std::ifstream in(kScenes / file);
    std::string schema, licence, header;
    std::getline(in, schema);
    std::getline(in, licence);
    std::getline(in, header);
    CHECK(schema == "#:schema ../docs/scene.schema.json");
    CHECK(licence == "# SPDX-License-Identifier: Apache-2.0");
    CHECK(header.starts_with("# "));
    CHECK_NOTHROW(loadScene(kScenes / file));
  }
}

TEST_CASE("of every population's symmetry the most is used: rings for random crystals, mirror images for all others") {
  for (const std::string& file : sceneFiles()) {
    CAPTURE(file);
    const Scene scene = loadScene(kScenes / file).scene;
    const Cloud cloud = cloudOf(scene);
    CHECK(scene.trace.symmetry == Symmetry::automatic);
    const std::vector<TallySymmetry> symmetries = symmetriesOf(cloud, scene.trace.symmetry);
    for (std::size_t p = 0; p < symmetries.size(); ++p) {
      const bool random = cloud.populations()[p].isFullyRandom();
      CHECK(symmetries[p] == (random ? TallySymmetry::radial : TallySymmetry::mirror));
    }
    for (const Symmetry asked : {Symmetry::none, Symmetry::mirror, Symmetry::radial})
      CHECK(symmetryOf(cloud, asked) == asked);
  }
}

TEST_CASE("every scene shows at 550 nm what its header says, where it says it") {
  for (const SceneClaims& scene : kClaims) {
    CAPTURE(scene.file);
    const std::vector<std::string> overrides{"sun.spectrum=550", "sun.diameter=0", "sky.air=false"};
    const Scene settings = loadScene(kScenes / scene.file, overrides).scene;
    std::vector<Histogram> histograms;
    for (const Claim& claim : scene.claims) histograms.push_back(around(claim));
    forEachRay(cloudOf(settings), 1'000'000, [&](const LightPath& path) {
      for (const Exit& exit : path.exits)
        for (std::size_t i = 0; i < histograms.size(); ++i) addExit(scene.claims[i], path, exit, histograms[i]);
    });
    for (std::size_t i = 0; i < histograms.size(); ++i) {
      const Claim& claim = scene.claims[i];
      const bool isRing = claim.what == What::ring;
      const double found = isRing ? fitEdge(histograms[i]).position : histograms[i].peak();
      CHECK(std::abs(found - claim.where) < (isRing ? 0.1 : 0.5));
    }
  }
}
